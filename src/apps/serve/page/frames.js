// Pictures from the server, the status line and saved files.

function trouble(line) {
    at('trouble').textContent = line;
    at('trouble').hidden = !line;
}

const percent = part => `${(100 * part).toPrecision(2)} %`;

function tracedStatus(size, { traced, last }) {
    const { samples, noise, error, flip } = traced;
    const noiseWords = noise === undefined ? '' : `, noise ${percent(noise)}`;
    const flipWords = flip === undefined ? '' : `, FLIP ${flip.toFixed(3)}`;
    return `${size}, traced: ${Math.round(samples)} samples${noiseWords}; drawn picture's error ${percent(error)}` +
        `${flipWords}${last ? '' : ', refining'}`;
}

// The measured error with the interval that holds the true one.
function errorWords({ error }) {
    if (!error) return '';
    const number = part => (100 * part).toPrecision(2);
    return `, error ${number(error.relative_rmse)} % (${number(error.low)} to ${number(error.high)})`;
}

const recent = [];
function showStatus(header) {
    const now = performance.now();
    recent.push(now);
    while (recent.length > 1 && now - recent[0] > 1000) recent.shift();
    const moving = header.kind === 'moving';
    const rate = moving && recent.length > 2 ? `${Math.round((recent.length - 1) * 1000 / (now - recent[0]))}/s, ` : '';
    const size = `${header.width}×${header.height}`;
    if (header.traced) {
        at('status').textContent = tracedStatus(size, header);
        return;
    }
    const time = `${header.draw_ms.toFixed(0)} ms`;
    const shadows = header.lacks_shadows ? ', without shadows' : '';
    at('status').textContent = moving ? `${rate}${size} at ${Math.round(100 * header.scale)} %, ${time}${shadows}`
                                      : `${size}, ${time}${errorWords(header)}${header.last ? '' : ', refining'}`;
}

// Decoding is asynchronous; this chain shows pictures in the order of their arrival.
let shown = Promise.resolve();
function showFrame(header, bytes) {
    shown = shown.then(async () => {
        const picture = await createImageBitmap(new Blob([bytes], { type: `image/${header.format}` }),
                                                { colorSpaceConversion: 'none' });
        canvas.width = picture.width;
        canvas.height = picture.height;
        paint.drawImage(picture, 0, 0);
        picture.close();
        Object.assign(canvas.dataset, { kind: header.kind, input: header.input, scale: header.scale,
                                        frames: Number(canvas.dataset.frames ?? 0) + 1 });
        showStatus(header);
        showMoment(header.moment);
    }).catch(error => trouble(`A picture could not be shown: ${error.message}`)).then(() => {
        if (socket.readyState === WebSocket.OPEN) socket.send('{"do":"seen"}');
    });
}

function keep(header, bytes) {
    const address = URL.createObjectURL(new Blob([bytes], { type: 'application/octet-stream' }));
    const link = element('a', { href: address, download: header.name });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), 60000);
}
