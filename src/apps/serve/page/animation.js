// Controls for animations.

const duration = () => state?.seconds ?? 0;

function showMoment(seconds) {
    if (document.activeElement !== at('moment') || state?.playing)
        at('moment').value = duration() > 0 ? Math.round(1000 * seconds / duration()) : 0;
    at('seconds').textContent = `${seconds.toFixed(2)} s`;
}

function showAnimation() {
    at('animation').hidden = state.animations.length === 0;
    at('animate').replaceChildren(element('option', { value: -1, textContent: 'none' }),
        ...state.animations.map(({ name }, index) => element('option', { value: index, textContent: name })));
    choose(at('animate'), String(state.animation));
    at('moment').disabled = !(duration() > 0);
    at('play').textContent = state.playing ? 'Pause' : 'Play';
    at('play').setAttribute('aria-pressed', String(state.playing));
    showMoment(state.moment);
}

function togglePlay() {
    if (state?.animations.length > 0) say({ do: 'play', on: !state.playing });
}

at('play').addEventListener('click', togglePlay);
at('animate').addEventListener('change', event => say({ do: 'animate', number: Number(event.target.value) }));
at('moment').addEventListener('input', event => {
    const seconds = Number(event.target.value) / 1000 * duration();
    say({ do: 'moment', seconds });
    at('seconds').textContent = `${seconds.toFixed(2)} s`;
});
