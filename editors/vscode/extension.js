// Starts `bosquet lsp` and hands it the rule files of the workspace. Everything that is known of the language is there.
const { commands, window, workspace } = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

/** A client for the command that the settings name. */
function make() {
  const settings = workspace.getConfiguration("bosquet");
  const server = { command: settings.get("path") || "bosquet", args: ["lsp"] };
  const watcher = workspace.createFileSystemWatcher("**/*.cga");
  return new LanguageClient("bosquet", "bosquet", server, {
    documentSelector: [{ language: "cga" }],
    initializationOptions: { pictures: settings.get("pictures") || null },
    synchronize: { fileEvents: watcher },
  });
}

/** Starts the server; where it is not found, says what to do. */
async function start() {
  client = make();
  try {
    await client.start();
  } catch (error) {
    const command = workspace.getConfiguration("bosquet").get("path");
    const choice = await window.showErrorMessage(
      `\`${command}\` could not be started (${error.message}): install bosquet, or set \`bosquet.path\`.`,
      "Open settings",
    );
    if (choice) {
      await commands.executeCommand("workbench.action.openSettings", "bosquet.path");
    }
  }
}

/** Ends the server. */
async function stop() {
  const old = client;
  client = undefined;
  if (old?.isRunning()) {
    await old.stop();
  }
}

async function restart() {
  await stop();
  await start();
}

exports.activate = async (context) => {
  context.subscriptions.push(
    commands.registerCommand("bosquet.restart", restart),
    workspace.onDidChangeConfiguration(async (change) => {
      if (change.affectsConfiguration("bosquet.path") || change.affectsConfiguration("bosquet.pictures")) {
        await restart();
      }
    }),
  );
  await start();
};

exports.deactivate = stop;
