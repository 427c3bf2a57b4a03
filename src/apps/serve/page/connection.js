'use strict';

// The socket to the server, and the page's helpers. CMake joins the scripts of this folder into one, this one first.

const at = id => document.getElementById(id);
const canvas = at('picture'), paint = canvas.getContext('2d');
const socket = new WebSocket(
    `${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/socket${location.search}`);
socket.binaryType = 'arraybuffer';

let inputs = 0, state = null, table = [], scenes = [];

function say(message) {
    if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify({ ...message, id: ++inputs }));
}

// Sums the moves of each kind between two frames of the screen into one message.
const moves = new Map();
function move(name, amounts) {
    const sum = moves.get(name) ?? {};
    for (const [key, amount] of Object.entries(amounts)) sum[key] = (sum[key] ?? 0) + amount;
    if (moves.size === 0)
        requestAnimationFrame(() => {
            for (const [what, all] of moves) say({ do: what, ...all });
            moves.clear();
        });
    moves.set(name, sum);
}

function element(tag, properties = {}, ...children) {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children);
    return made;
}
