// Cube maps read by the programs they are for: ktx-parse, three.js's KTX2Loader and Babylon.js's DDS loader.
// node check.mjs WRITE_CUBES. Exits with 77, which skips the test, where the packages are not there.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const size = 8, levels = 4, texelCount = level => 4 ** (3 - level);

async function packages() {
    try {
        return {
            parse: await import('ktx-parse'),
            three: await import('three'),
            KTX2Loader: (await import('three/addons/loaders/KTX2Loader.js')).KTX2Loader,
            DDSTools: (await import('@babylonjs/core/Misc/dds.pure.js')).DDSTools,
            babylon: (await import('@babylonjs/core/Engines/constants.js')).Constants,
            half: (await import('@babylonjs/core/Misc/textureTools.js')).FromHalfFloat,
        };
    } catch (error) {
        if (error.code !== 'ERR_MODULE_NOT_FOUND') throw error;
        console.log('skipped: no packages here; `node tests/support/fetch.mjs tests/consumers` gets them');
        process.exit(77);
    }
}

// A buffer of its own: loaders look at the whole of it.
const bytesOf = file => new Uint8Array(readFileSync(file));

// The numbers of write_cubes.cpp; `read` gives a texel's channels.
function checkFace(read, face, level) {
    const side = size >> level;
    for (let y = 0; y < side; ++y)
        for (let x = 0; x < side; ++x)
            assert.deepEqual(read(y * side + x), [8 * y + x + 1, face + 1, level + 1],
                `face ${face} level ${level} x ${x} y ${y}`);
}

const { parse, three, KTX2Loader, DDSTools, babylon, half } = await packages();

const readers = {
    half4: data => i => [0, 1, 2].map(c => three.DataUtils.fromHalfFloat(data[4 * i + c])),
    float4: data => i => [0, 1, 2].map(c => data[4 * i + c]),
    rgb9e5: data => i => [0, 9, 18].map(shift => (data[i] >>> shift & 511) * 2 ** ((data[i] >>> 27) - 24)),
};
const perTexel = { half4: 4, float4: 4, rgb9e5: 1 };

function checkParsed(name, bytes) {
    const format = name.split('.')[0], file = parse.read(bytes);
    const vkFormat = {
        half4: parse.VK_FORMAT_R16G16B16A16_SFLOAT,
        float4: parse.VK_FORMAT_R32G32B32A32_SFLOAT,
        rgb9e5: parse.VK_FORMAT_E5B9G9R9_UFLOAT_PACK32,
    }[format];
    assert.equal(file.vkFormat, vkFormat);
    assert.deepEqual([file.pixelWidth, file.pixelHeight, file.pixelDepth], [size, size, 0]);
    assert.deepEqual([file.faceCount, file.layerCount, file.levels.length], [6, 0, levels]);
    assert.equal(file.keyValue.KTXorientation, 'rd');
    assert.equal(file.keyValue.KTXwriter, 'lambent');
    const [block] = file.dataFormatDescriptor;
    assert.equal(block.colorModel, parse.KHR_DF_MODEL_RGBSDA);
    assert.equal(block.colorPrimaries, parse.KHR_DF_PRIMARIES_BT709);
    assert.equal(block.transferFunction, parse.KHR_DF_TRANSFER_LINEAR);
    assert.equal(block.samples.length, format === 'rgb9e5' ? 6 : 4);
    if (file.supercompressionScheme !== parse.KHR_SUPERCOMPRESSION_NONE) return;
    // Only the format's own keys are taken for text there.
    assert.equal(new TextDecoder().decode(file.keyValue['lambent.test']), 'an odd one\0');
    // Its own writer puts every byte where ours did.
    assert.deepEqual(parse.write(file, { keepWriter: true }), bytes);
}

async function checkThree(name, bytes) {
    const format = name.split('.')[0], loader = new KTX2Loader();
    loader.workerConfig = {}; // nothing to transcode
    const texture = await new Promise((done, failed) => loader.parse(bytes.buffer, done, failed));
    const [channels, type] = {
        half4: [three.RGBAFormat, three.HalfFloatType],
        float4: [three.RGBAFormat, three.FloatType],
        rgb9e5: [three.RGBFormat, three.UnsignedInt5999Type],
    }[format];
    assert.deepEqual([texture.format, texture.type], [channels, type]);
    assert.equal(texture.colorSpace, three.LinearSRGBColorSpace);
    assert.equal(texture.mipmaps.length, levels);
    // No cube for uncompressed formats there, but a texture whose levels hold six faces one after another.
    texture.mipmaps.forEach((mip, level) => {
        assert.deepEqual([mip.width, mip.height], [size >> level, size >> level]);
        const length = texelCount(level) * perTexel[format];
        assert.equal(mip.data.length, 6 * length);
        for (let face = 0; face < 6; ++face)
            checkFace(readers[format](mip.data.subarray(face * length, (face + 1) * length)), face, level);
    });
}

function checkBabylon(name, bytes) {
    const info = DDSTools.GetDDSInfo(bytes);
    assert.deepEqual([info.width, info.height, info.mipmapCount, info.isCube], [size, size, levels, true]);
    assert.equal(info.isFourCC, true);
    const format = name.split('.')[0];
    assert.equal(info.dxgiFormat, { half4: 10, float4: 2, rgb9e5: 67 }[format]);
    if (format === 'rgb9e5') return; // goes no further there
    // An engine that only looks at what it is given.
    let uploads = 0;
    const engine = {
        getCaps: () => ({
            textureFloat: true, textureFloatLinearFiltering: true,
            textureHalfFloat: true, textureHalfFloatLinearFiltering: true,
        }),
        _getRGBABufferInternalSizedFormat: () => 0,
        _uploadDataToTextureDirectly(texture, data, face, level) {
            ++uploads;
            assert.equal(data.length, 4 * texelCount(level));
            const read = format === 'half4' ? half : value => value;
            checkFace(i => [0, 1, 2].map(c => read(data[4 * i + c])), face, level);
            assert.equal(read(data[3]), 1);
        },
    };
    const texture = {};
    DDSTools.UploadDDSLevels(engine, texture, bytes, info, true, 6);
    assert.equal(uploads, 6 * levels);
    const { TEXTURETYPE_HALF_FLOAT, TEXTURETYPE_FLOAT } = babylon;
    assert.equal(texture.type, format === 'half4' ? TEXTURETYPE_HALF_FLOAT : TEXTURETYPE_FLOAT);
}

const folder = mkdtempSync(join(tmpdir(), 'lambent-consumers-'));
try {
    execFileSync(process.argv[2], [folder]);
    const names = readdirSync(folder).sort();
    assert.ok(names.length === 6 || names.length === 9, names.join(' '));
    for (const name of names) {
        const bytes = bytesOf(join(folder, name));
        if (name.endsWith('.dds')) {
            checkBabylon(name, bytes);
        } else {
            checkParsed(name, bytes);
            await checkThree(name, bytes);
        }
        console.log(`${name}: ${bytes.length} bytes, read`);
    }
} finally {
    rmSync(folder, { recursive: true });
}
