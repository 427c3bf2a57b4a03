// What the page does when it is used.
import assert from 'node:assert/strict';

// Where the division is: of the range's numbers, of what is clipped and of the line, all in percent.
const divisionOf = stage => stage.evaluate(element => {
    const box = element.getBoundingClientRect(), range = element.querySelector('input');
    const line = element.querySelector('.line').getBoundingClientRect();
    const clip = getComputedStyle(element.querySelector('.left')).clipPath;
    const right = /^inset\(0px (?:calc\(100% - ([\d.]+)%\)|([\d.]+)(%|px)?)/.exec(clip);
    if (!right) throw new Error(`clipped by ${clip}`);
    return {
        value: Number(range.value),
        now: Number(range.getAttribute('aria-valuenow')),
        clip: right[1] !== undefined ? Number(right[1]) : 100 - Number(right[2]),
        line: 100 * (line.x + line.width / 2 - box.x) / box.width,
    };
});

async function expectDivision(stage, expected, tolerance) {
    const division = await divisionOf(stage);
    for (const [name, value] of Object.entries(division))
        assert.ok(Math.abs(value - expected) <= tolerance, `${name} is ${value}, not ${expected}`);
}

async function dragTo(page, stage, from, to) {
    const box = await stage.boundingBox(), at = share => [box.x + box.width * share, box.y + box.height / 2];
    await page.mouse.move(...at(from));
    await page.mouse.down();
    await page.mouse.move(...at((from + to) / 2));
    await page.mouse.move(...at(to));
    await page.mouse.up();
}

async function sliders({ open, report }) {
    const kinds = report.sections.flatMap(section => section.figures).map(figure => figure.kind);
    for (const width of [390, 1440])
        await open({ width }, async page => {
            const stages = page.locator('.stage');
            assert.equal(await stages.count(), kinds.filter(kind => kind === 'comparison').length);
            for (const stage of await stages.all()) {
                await stage.scrollIntoViewIfNeeded();
                await expectDivision(stage, 50, 0.5);
                await dragTo(page, stage, 0.5, 0.25);
                await expectDivision(stage, 25, 1);
                await dragTo(page, stage, 0.8, 0.9);
                await expectDivision(stage, 90, 1);
                await slideByKeys(page, stage);
            }
        });
}

async function slideByKeys(page, stage) {
    await stage.locator('input').focus();
    await page.keyboard.press('Home');
    await expectDivision(stage, 0, 0.5);
    for (let i = 0; i < 10; ++i) await page.keyboard.press('ArrowRight');
    const { value } = await divisionOf(stage);
    assert.ok(value > 0);
    await page.keyboard.press('ArrowLeft');
    assert.ok((await divisionOf(stage)).value < value);
    await page.keyboard.press('End');
    await expectDivision(stage, 100, 0.5);
}

// Any two pictures of a comparison, by keyboard; each side says which it is.
async function choosers({ open, report }) {
    const figures = report.sections.flatMap(section => section.figures)
        .filter(({ kind, pictures }) => kind === 'comparison' && pictures.length > 2);
    await open({}, async page => {
        for (const figure of figures) {
            const part = page.locator(`[id="${figure.id}"]`);
            const files = figure.pictures.map(picture => picture.file);
            const shown = async () => Promise.all(['left', 'right'].map(async side =>
                decodeURI(await part.locator(`.side.${side} img`).getAttribute('src'))));
            assert.deepEqual(await shown(), files.slice(0, 2));
            const selects = part.locator('.choosers select');
            await selects.nth(1).focus();
            await page.keyboard.press('End');
            assert.deepEqual(await shown(), [files[0], files.at(-1)]);
            await selects.nth(0).focus();
            await page.keyboard.press('ArrowDown');
            assert.deepEqual(await shown(), [files[1], files.at(-1)]);
            await page.keyboard.press('End');
            assert.deepEqual(await shown(), [files.at(-1), files[1]], 'the same picture twice');
        }
    });
}

const viewerState = page => page.evaluate(() => {
    const viewer = document.getElementById('viewer'), texts = selector =>
        [...viewer.querySelectorAll(selector)].map(element => element.textContent);
    const image = viewer.querySelector('.viewer-stage img');
    return {
        isOpen: viewer.open,
        file: image && decodeURI(image.getAttribute('src')),
        title: texts('#viewer-title')[0],
        numbers: texts('.numbers div'),
        commands: texts('code'),
        hasFocus: viewer.contains(document.activeElement),
    };
});

function expectShown(state, picture) {
    assert.ok(state.isOpen && state.hasFocus);
    assert.equal(state.file, picture.file);
    assert.ok(state.title.includes(picture.title) && state.title, state.title);
    if (picture.figure) assert.ok(state.title.includes(picture.figure.number), state.title);
    assert.deepEqual(state.numbers, picture.numbers.map(({ name, value }) => name + value));
    assert.deepEqual(state.commands, picture.commands);
}

async function viewer({ open, pictures }) {
    await open({}, async page => {
        const views = page.locator('.view');
        assert.equal(await views.count(), pictures.length);
        await views.first().click();
        for (const picture of pictures) {
            expectShown(await viewerState(page), picture);
            await page.keyboard.press('ArrowRight');
        }
        expectShown(await viewerState(page), pictures[0]);
        await page.keyboard.press('ArrowLeft');
        expectShown(await viewerState(page), pictures.at(-1));
        await page.locator('#viewer .previous').click();
        await page.locator('#viewer .next').click();
        expectShown(await viewerState(page), pictures.at(-1));
        const drawn = await page.locator('.viewer-stage img').evaluate(image => image.decode().then(() =>
            image.getBoundingClientRect().width > 100 && image.getBoundingClientRect().height > 100));
        assert.ok(drawn, 'the picture is too small to see');
    });
}

async function viewerFocus({ open, pictures }) {
    await open({}, async page => {
        const index = Math.min(1, pictures.length - 1), last = pictures.length - 1;
        // A dialogue says that it was closed when it has its turn, and the page then moves the focus.
        const isBack = (place = index) => page.waitForFunction(
            at => document.querySelectorAll('.view')[at] === document.activeElement, place, { timeout: 5000 })
            .then(() => true, () => false);
        await page.locator('.view').nth(index).focus();
        await page.keyboard.press('Enter');
        expectShown(await viewerState(page), pictures[index]);
        for (const key of ['Tab', 'Shift+Tab'])
            for (let i = 0; i < 9; ++i) {
                await page.keyboard.press(key);
                assert.ok((await viewerState(page)).hasFocus, `${key} leaves the viewer`);
            }
        await page.keyboard.press('Escape');
        assert.ok(!(await viewerState(page)).isOpen && await isBack(), 'Escape');
        await page.keyboard.press('Enter');
        await page.locator('#viewer .close').click();
        assert.ok(!(await viewerState(page)).isOpen && await isBack(), 'the close button');
        await page.locator('.view').first().click();
        await page.keyboard.press('ArrowLeft');
        await page.keyboard.press('Escape');
        assert.ok(await isBack(last), 'the picture that was looked at last');
    });
}

async function pixels({ open }) {
    await open({}, async page => {
        await page.locator('.view').first().click();
        const rendering = () => page.locator('.viewer-stage img').evaluate(image =>
            getComputedStyle(image).imageRendering);
        assert.equal(await rendering(), 'auto');
        await page.locator('#viewer .pixels').click();
        assert.equal(await rendering(), 'pixelated');
        assert.equal(await page.locator('#viewer .pixels').getAttribute('aria-pressed'), 'true');
    });
}

// Presses every copy button; `taken` reads in the page what came of it.
async function copyAll(page, word, taken) {
    for (const details of await page.locator('.made').all()) {
        await details.locator('summary').focus();
        await page.keyboard.press('Enter');
        assert.ok(await details.evaluate(element => element.open));
        const button = details.locator('.copy').first();
        // Seen from before the click on: a slow machine may look only when the word is gone again.
        await button.evaluate(element => {
            element.said = new Promise(said => {
                const watch = new MutationObserver(() => said(element.textContent));
                watch.observe(element, { childList: true, characterData: true, subtree: true });
            });
        });
        await button.click();
        assert.equal(await button.evaluate(element => element.said), word);
        assert.equal(await page.evaluate(taken), await details.locator('code').first().textContent());
    }
}

async function copying({ open }) {
    await open({ permissions: ['clipboard-read', 'clipboard-write'] }, page =>
        copyAll(page, 'Copied', () => navigator.clipboard.readText()));
}

// Then the command is selected, ready for the keyboard.
async function copyingWithoutClipboard({ open }) {
    const prepare = () => Object.defineProperty(navigator, 'clipboard', { value: undefined });
    await open({ prepare }, page => copyAll(page, 'Selected', () => getSelection().toString()));
}

const lightness = page => page.evaluate(() => {
    const [red, green, blue] = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number);
    return (red + green + blue) / 765;
});

async function expectTheme(page, theme) {
    // A change of the system's scheme reaches the page's script in its own time.
    await page.locator(`.theme[aria-pressed="${theme === 'dark'}"]`).waitFor();
    const light = await lightness(page);
    assert.ok(theme === 'light' ? light > 0.8 : light < 0.2, `${theme}: ${light}`);
    assert.equal(await page.locator('.theme').getAttribute('aria-pressed'), String(theme === 'dark'));
}

const other = { light: 'dark', dark: 'light' };

async function themes({ open }) {
    for (const scheme of ['light', 'dark'])
        await open({ scheme }, async page => {
            await expectTheme(page, scheme);
            await page.emulateMedia({ colorScheme: other[scheme] });
            await expectTheme(page, other[scheme]);
            const stored = () => page.evaluate(() => localStorage.getItem('lambent-theme'));
            let canStore = true;
            // Under load Chromium now and then reloads without what was stored a moment before: then once more.
            for (let tries = 0; tries < 3; ++tries) {
                await page.locator('.theme').click();
                await expectTheme(page, scheme);
                canStore = await stored() === scheme;
                await page.reload();
                if (!canStore || await stored()) break;
            }
            await expectTheme(page, canStore ? scheme : other[scheme]);
        });
}

async function themesUnstored({ open }) {
    const prepare = () => {
        Object.defineProperty(window, 'localStorage', { get() { throw new Error('forbidden'); } });
    };
    await open({ prepare }, async page => {
        await page.locator('.theme').click();
        await expectTheme(page, 'dark');
    });
}

async function contents({ open, report }) {
    await open({ width: 390, height: 844 }, async page => {
        const section = report.sections.at(-1);
        await page.locator('.folded summary').focus();
        await page.keyboard.press('Enter');
        await page.locator('.folded nav a', { hasText: section.title }).first().click();
        assert.equal(await page.locator('.folded').evaluate(element => element.open), false);
        assert.equal(decodeURIComponent(new URL(page.url()).hash), `#${section.id}`);
    });
    await open({}, async page => {
        await page.locator('.beside > ol > li > a').last().click();
        await page.waitForFunction(() => document.querySelector('.beside li:last-child > a[aria-current]') ||
            scrollY + innerHeight >= document.documentElement.scrollHeight - 2);
    });
}

export const useChecks = {
    'sliders by mouse and by keys': sliders,
    'choosers of what is compared': choosers,
    'the viewer and all that belongs to a picture': viewer,
    'the viewer keeps the focus and gives it back': viewerFocus,
    'pixels as squares': pixels,
    'commands open and are copied': copying,
    'commands are selected where there is no clipboard': copyingWithoutClipboard,
    'light, dark and the button between': themes,
    'the button without storage': themesUnstored,
    'the contents lead there': contents,
};
