// Answers requests as judge_lines does, but by the module: node --no-experimental-fetch lines.js FOLDER <requests
const fs = require('fs');
const folder = process.argv[2];
const make = require(folder + '/judge.js');
const lines = fs.readFileSync(0, 'utf8').split('\n').filter((line) => line);
make({wasmBinary: fs.readFileSync(folder + '/judge.wasm'), print: () => {}}).then((judge) => {
  for (const line of lines) console.log(judge.ccall('rederive_reply', 'string', ['string'], [line]));
});
