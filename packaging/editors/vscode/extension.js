// The live page of a mechanism file beside its text: `kinegraph watch` serves it and makes it anew whenever the file is
// saved. One process a file; all end with the editor. Schema and snippets need no code (package.json).
"use strict";

const { spawn } = require("node:child_process");
const vscode = require("vscode");

/** @type {Map<string, import("node:child_process").ChildProcess>} by path of the file */
const watching = new Map();

/** The page's address is the first line that the program prints. */
function addressOf(process) {
  return new Promise((resolve, reject) => {
    let said = "", complaint = "";
    process.stdout.on("data", data => {
      said += data;
      const address = /^(http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]+\/)\s*$/m.exec(said);
      if (address) resolve(address[1]);
    });
    process.stderr.on("data", data => (complaint = (complaint + data).slice(-2000)));
    process.on("error", error => reject(new Error(`${error.message} (setting kinegraph.program)`)));
    process.on("exit", status => reject(new Error(complaint.trim() || `kinegraph ended with status ${status}`)));
  });
}

async function preview() {
  const document = vscode.window.activeTextEditor?.document;
  if (!document || document.isUntitled || document.uri.scheme !== "file") {
    vscode.window.showErrorMessage("Kinegraph: save the mechanism file first.");
    return;
  }
  const file = document.uri.fsPath;
  stop(file);
  const settings = vscode.workspace.getConfiguration("kinegraph", document.uri);
  const process = spawn(settings.get("program"), ["watch", "--lang", settings.get("language"), "--", file]);
  watching.set(file, process);
  process.on("exit", () => {
    if (watching.get(file) === process) watching.delete(file);
  });
  try {
    await vscode.env.openExternal(vscode.Uri.parse(await addressOf(process)));
  } catch (error) {
    watching.delete(file);
    vscode.window.showErrorMessage(`Kinegraph: ${error.message}`);
  }
}

function stop(file) {
  watching.get(file)?.kill();
  watching.delete(file);
}

function stopAll() {
  for (const file of [...watching.keys()]) stop(file);
}

function activate(context) {
  context.subscriptions.push(
    vscode.commands.registerCommand("kinegraph.preview", preview),
    vscode.commands.registerCommand("kinegraph.stop", stopAll),
    { dispose: stopAll },
  );
}

module.exports = { activate, deactivate: stopAll };
