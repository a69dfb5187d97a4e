//! The declaration macro: one `operation!` a file gives the typed struct, its `SPEC` and its entry in the list.

/// Declares an operation: its manual, name, block and parameters.
///
/// ```text
/// operation! {
///     /// Sweeps the shape upwards.
///     "extrude" (CityEngine, None) => pub struct Extrude {
///         /// How far (metres).
///         height: Metres,
///         /// Which way.
///         direction: Direction = Direction::Up => "world.up",
///     }
/// }
/// ```
///
/// Behind a default stands how the manual writes it; `[1.0, 10.0]` behind a type is the usual range. `impl Apply for Extrude` follows by hand.
macro_rules! operation {
    (
        $(#[doc = $doc:literal])*
        $name:literal $(| $alias:literal)* ($origin:ident, $block:expr) => pub struct $type:ident {
            $( $(#[doc = $pdoc:literal])* $field:ident : $ptype:ty $([$low:literal, $high:literal])?
               $(= $default:expr => $text:literal)? ),* $(,)?
        }
    ) => {
        $(#[doc = $doc])*
        #[derive(Clone, Debug)]
        pub struct $type { $( $(#[doc = $pdoc])* pub $field: $ptype ),* }

        impl $type {
            /// The declaration that checker, engine, manual and editor read.
            pub const SPEC: $crate::ops::Spec = $crate::ops::Spec {
                name: $name,
                aliases: &[$($alias),*],
                docs: concat!($($doc, "\n"),*),
                params: &[$( $crate::ops::Param {
                    name: stringify!($field),
                    docs: concat!($($pdoc, "\n"),*),
                    kind: <$ptype as $crate::ops::Parameter>::KIND,
                    default: $crate::ops::declare::operation!(@text $($text)?),
                    usual: $crate::ops::declare::operation!(@usual $($low, $high)?),
                } ),*],
                block: { use $crate::ops::BlockKind::*; $block },
                origin: $crate::ops::Origin::$origin,
            };
            /// The operation as the engine finds it.
            pub const OPERATION: $crate::ops::Operation = $crate::ops::Operation::of::<$type>(&$type::SPEC);
        }

        impl $crate::ops::Decode for $type {
            fn decode(values: &mut [Option<$crate::value::Value>]) -> Result<Self, $crate::ops::Problem> {
                let mut values = values.iter_mut().map(Option::take);
                let decoded = $type { $( $field: {
                    let value = values.next().flatten();
                    $crate::ops::declare::operation!(@decode $field, $ptype, value $(, $default)?)
                } ),* };
                debug_assert!(values.next().is_none(), "more values than `{}` has parameters", $name);
                Ok(decoded)
            }
        }
    };
    (@usual) => { None };
    (@usual $low:literal, $high:literal) => { Some([$low, $high]) };
    (@text) => { None };
    (@text $text:literal) => { Some($text) };
    (@decode $field:ident, $ptype:ty, $value:ident) => {
        match $value {
            Some(value) => $crate::ops::decode_value::<$ptype>(stringify!($field), value)?,
            None => return Err($crate::ops::Problem::missing(stringify!($field))),
        }
    };
    (@decode $field:ident, $ptype:ty, $value:ident, $default:expr) => {
        match $value {
            Some(value) => $crate::ops::decode_value::<$ptype>(stringify!($field), value)?,
            None => $default,
        }
    };
}
pub(crate) use operation;
