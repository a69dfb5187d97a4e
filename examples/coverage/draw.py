"""Draws the example: the layout (coverage.geojson), the coverage map (cover.png) and its world file (cover.pgw).

An invented block of a suburb in local metres, and the tree cover that a segmentation of an aerial photograph would
give of it: soft-edged crowns, run together into groves behind the houses, single before them and along the streets.
Needs nothing but Python 3:  python3 draw.py
"""

import json, math, random, struct, zlib

random.seed(12)
PIXEL = 0.5
WEST, SOUTH, EAST, NORTH = -4.0, -18.0, 204.0, 144.0
WIDTHS = [[32, 36, 30, 38, 34, 30], [36, 30, 34, 30, 38, 32]]
MIDDLE, DEPTH = 63.0, 126.0


def rectangle(x, y, w, d):
    return [[x, y], [x + w, y], [x + w, y + d], [x, y + d], [x, y]]


def feature(kind, ring, **properties):
    geometry = {"type": "Polygon", "coordinates": [[[round(a, 2) for a in p] for p in ring]]}
    return {"type": "Feature", "properties": {"kind": kind, **properties}, "geometry": geometry}


def turned(ring):
    """The same on the other side of the block."""
    return [[200 - x, DEPTH - y] for x, y in ring]


features, houses, drives = [], [], []
for row, widths in enumerate(WIDTHS):
    x = 0.0
    for number, width in enumerate(widths):
        place = turned if row else list
        # The boundary between the rows runs a little aslant.
        back = lambda x: MIDDLE + (1 if row == 0 else -1) * (x - 100) * (0.03 if row == 0 else -0.03)
        edge = [[x, 0], [x + width, 0], [x + width, back(x + width)], [x, back(x)], [x, 0]]
        name = "%d %s Road" % (2 * number + 1 + row, "North" if row else "South")
        features.append(feature("lot", place(edge), id="%s%d" % ("n" if row else "s", number + 1), name=name,
                                zone="residential"))
        w, d, front = random.uniform(12, 16), random.uniform(9, 12), random.uniform(9, 13)
        left = x + 3 + random.uniform(0, width - w - 9.5)
        garage = left + w
        ring = [[left, front], [left + w, front], [left + w, front + 3], [garage + 3.5, front + 3],
                [garage + 3.5, front + 9], [left + w, front + 9], [left + w, front + d], [left, front + d],
                [left, front]]
        houses.append(place(ring))
        features.append(feature("building", place(ring), height=round(random.uniform(5, 8), 1)))
        drives.append(place(rectangle(garage + 0.2, 0, 3.1, front + 3)))
        features.append(feature("driveway", drives[-1]))
        x += width
for name, y in (("South Road", -12), ("North Road", DEPTH + 5)):
    features.append(feature("street", rectangle(-4, y, 208, 7), name=name))
for name, y in (("South verge", -5), ("North verge", DEPTH)):
    features.append(feature("avenue", rectangle(0, y, 200, 5), id=name.lower().replace(" ", "-"), name=name))

# Crowns: centre, radius, and how far the outline wanders.
crowns = []


def crown(x, y, radius):
    crowns.append((x, y, radius, random.uniform(0, 6.3), random.uniform(0, 6.3)))


for y in (-2.5, DEPTH + 2.5):
    x = random.uniform(3, 9)
    while x < 199:
        if random.random() < 0.85:
            crown(x + random.uniform(-0.7, 0.7), y, random.uniform(2.2, 3.6))
        x += random.uniform(8, 11)
for _ in range(11):
    # Groves along the backs, and some up to the side of a house.
    x, y = random.uniform(6, 194), MIDDLE + random.gauss(0, 7)
    for _ in range(random.randint(5, 13)):
        crown(x + random.gauss(0, 7), y + random.gauss(0, 3.5), random.uniform(2, 4.5))
for _ in range(34):
    crown(random.uniform(3, 197), random.choice([random.uniform(3, 48), random.uniform(78, DEPTH - 3)]),
          random.uniform(1.2, 3.2))


def inside(x, y, ring):
    hit = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:]):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            hit = not hit
    return hit


columns, rows = round((EAST - WEST) / PIXEL), round((NORTH - SOUTH) / PIXEL)
pixels = [bytearray(columns) for _ in range(rows)]
for cx, cy, radius, a, b in crowns:
    reach = radius * 1.4 + PIXEL
    for row in range(max(0, int((NORTH - cy - reach) / PIXEL)), min(rows, int((NORTH - cy + reach) / PIXEL) + 1)):
        for column in range(max(0, int((cx - reach - WEST) / PIXEL)), min(columns, int((cx + reach - WEST) / PIXEL) + 1)):
            x, y = WEST + (column + 0.5) * PIXEL, NORTH - (row + 0.5) * PIXEL
            angle = math.atan2(y - cy, x - cx)
            rim = radius * (1 + 0.12 * math.sin(3 * angle + a) + 0.08 * math.sin(5 * angle + b))
            # A classifier is sure within and doubts at the rim.
            share = 0.5 + (rim - math.hypot(x - cx, y - cy)) / 2.0
            value = round(17 * max(0.0, min(1.0, share)) * 15) if share > 0 else 0
            pixels[row][column] = max(pixels[row][column], min(255, value // 15 * 15))
for row in range(rows):
    for column in range(columns):
        x, y = WEST + (column + 0.5) * PIXEL, NORTH - (row + 0.5) * PIXEL
        if pixels[row][column] and any(inside(x, y, ring) for ring in houses):
            pixels[row][column] = 0


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


header = struct.pack(">IIBBBBB", columns, rows, 8, 0, 0, 0, 0)
scanlines = b"".join(b"\0" + bytes(line) for line in pixels)
with open("cover.png", "wb") as file:
    file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(scanlines, 9)) + chunk(b"IEND", b""))
with open("cover.pgw", "w") as file:
    file.write("%s\n0\n0\n-%s\n%s\n%s\n" % (PIXEL, PIXEL, WEST + PIXEL / 2, NORTH - PIXEL / 2))
with open("coverage.geojson", "w") as file:
    lines = ",\n  ".join(json.dumps(item) for item in features)
    file.write('{ "type": "FeatureCollection", "crs": "local", "features": [\n  %s\n] }\n' % lines)
