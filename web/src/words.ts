// What the page says: each word once, in the voice of the documentation.

export const glossary: [string, string][] = [
  ['gap', 'The distance g between the tip of the bar at rest and the wall. Displacements are counted in g.'],
  ['contact', 'The tip is held at the wall, which presses on it. n_c steps of it are a time t_c = n_c/N in L/c.'],
  ['flight', 'The tip is free, between two contacts. n_f steps of it are a time t_f = n_f/N in L/c.'],
  ['step', 'The time L/(Nc) in which a wave crosses one of the N cells of the bar.'],
  ['schedule', 'The contacts and flights of one period, such as (150, 900) on 300 cells.'],
  ['motion', 'What the bar does. A periodic one repeats itself after the period T.'],
  ['orbit', 'A motion regardless of the initial instant: two motions that differ by a shift in time are one orbit.'],
  ['family', 'All motions of one period and one contact pattern, named by three whole numbers (w, ν, k): T = 2ν/w, longest contact 2k/w, and every energy from a least one upwards.'],
  ['mode', 'A curve of motions, one for each period T of an interval, rational or not, with contact time t_c = 4a + bT.'],
  ['polygon', 'The motions with two contacts of one kind, over period and length of the first contact: the contact time can be divided between them freely.'],
  ['second stop', 'A stop on the other side of the tip, at u(L) = −h. Contacts with it are written L:(n_c, n_f).'],
  ['continuum', 'Motions of one period and one energy that can be changed into each other without a jump: the paper’s discovery.'],
  ['grazing', 'The tip touches the wall without force: a linear motion.'],
  ['E₁', 'EA g²/(2L), the least energy with which the tip can reach the wall.'],
  ['ω₁', 'πc/(2L), the first frequency of the bar without a wall. A period T in L/c is the frequency ω/ω₁ = 4/T.'],
  ['impulse', 'The force of the wall added up over a period, in EA g/c.'],
  ['damping ratio ζ', 'A dashpot at the tip dissipates energy: a wave is reflected there with the factor ρ = exp(−πζ).'],
  ['attracts', 'A slightly perturbed bar returns to the motion: it is stable. This was tested, not proved.'],
];

export const assumed = [
  'The bar is thin, straight, linear elastic and uniform; it moves along its axis only.',
  'The wall is rigid and fixed; it pushes and never pulls. There is no law of restitution: what the tip does follows from the waves.',
  'Energy is conserved unless damping is set.',
  'Displacements are drawn magnified; at g/L = 10⁻³ they would be invisible.',
];

export interface Control { title: string; text: string; formula: string }

/** Two sentences at each control, and its formula. */
export const controls: Record<string, Control> = {
  map: {
    title: 'The map',
    text: 'Every point of a line is a motion: point at one and the bar moves like that. Drag to zoom in; the wheel zooms with Ctrl, or after a click.',
    formula: 'Families (w, ν, k): T = 2ν/w, E/E₁ ≥ (w/win)². Modes: 1/√(E/E₁) = κT − μ. ω/ω₁ = 4/T.',
  },
  family: {
    title: 'Family',
    text: 'All motions of one period and one contact pattern, named by three whole numbers (w, ν, k).',
    formula: 'T = 2ν/w, longest contact 2k/w, E/E₁ ≥ (w/win)².',
  },
  energy: {
    title: 'Energy E/E₁',
    text: 'How hard the bar swings. From the least energy upwards there are motions of the same period; how far up they go on this page depends on the grid.',
    formula: 'E/E₁ = (2w/N) Σ z², z ≥ 0, Σ z = −N/win: the least at equal z, the most at one z alone.',
  },
  pause: {
    title: 'Another motion with the same energy and period',
    text: 'Walks along a continuum: the push of the wall splits in two, and this is the pause between them. Energy, period and impulse stay as they are.',
    formula: 'A straight cut of the simplex {z ≥ 0, Σ z = S} with the sphere Σ z² = const: the pulses stand λ apart.',
  },
  contact: {
    title: 'Contact time',
    text: 'Shorter or longer contact at the same period. These schedules are one family’s tent: all are faces of the same set of orbits.',
    formula: '|n_c − kG| < G leaves d = G − |n_c − kG| amplitudes, G = gcd(2N, n).',
  },
  period: {
    title: 'Period T along a mode',
    text: 'Between the grids there is a motion for every T, also an irrational one such as π. Its contact time and energy follow from T alone.',
    formula: 't_c = 4a + bT, 1/√(E/E₁) = κT − μ, p(t) = ±h with E/E₁ = 4h².',
  },
  scene: {
    title: 'What stands around the bar',
    text: 'A gap before one wall is the paper’s case; the bar can also touch the wall at rest, be pressed on it, or swing between two stops. Bars of several segments need a solver of linear programs (GLPK) that is not in the browser: the command line finds their motions by --segments.',
    formula: 'g > 0, g = 0, g < 0; a second stop: u(L) ≥ −h, which pushes the other way. Schedule: n_c:n_f, with L: at the second stop.',
  },
  polygon: {
    title: 'Two contacts in a period',
    text: 'Between the grids motions with two contacts fill polygons: besides the period T, the division of the contact time between the two contacts is free. Energy and period stay as they are while you move the slider.',
    formula: 'e_π(i) = s_i + 2k_i − m_i T, c₁ + c₂ = 2Σk − MT, 1/√(E/E₁) = κT − μ for all of them.',
  },
  damping: {
    title: 'Damping ζ',
    text: 'A dashpot at the tip absorbs a share of every wave that is reflected in flight. All linear modes decay alike.',
    formula: 'q = ρp + F/(1 + η), ρ = exp(−πζ), η = tanh(πζ/2).',
  },
  amplitude: {
    title: 'Amplitude of the excitation',
    text: 'A harmonic force on the tip, or a base that oscillates. For each period and contact time at most two motions have this amplitude.',
    formula: 'p = C pᶜ + S pˢ, u(L, 0) = g is a line in the plane (C, S), |(C, S)| = amplitude meets it at most twice.',
  },
  words: {
    title: 'A scene of parts',
    text: 'Bars in a row, from left to right, with all that stands at them. Drag a wall to move it, a bar to pull it (or to throw it, where nothing holds it), a part to another place; × removes it. All bars together are 1 L long.',
    formula: 'v = (2ΣZₖwₖ + f)/(ΣZₖ + D) at each node; followed front by front, no time step.',
  },
  sweep: {
    title: 'Sweep',
    text: 'The frequency goes up or down, and the bar continues from where it was: what it settles on fills in while you watch. Where the sweeps up and down differ, there is hysteresis.',
    formula: '60 frequencies, at most 200 periods at each. A bar from least to most impulse: it does not repeat itself every period.',
  },
  pace: {
    title: 'Slow motion',
    text: 'How much of the motion passes in a second of yours.',
    formula: 'L/c: the time in which a wave crosses the bar.',
  },
  pluck: {
    title: 'Pluck it',
    text: 'Drag the bar itself, or set where you hold it and how far you pull; then let go. Nothing is on a grid then: the bar is followed event by event.',
    formula: 'u = d·min(x/x₀, 1), v = 0. Then p_{m+2N} = ±p_m, contact while R = F + 2p ≥ 0.',
  },
  time: {
    title: 'Time',
    text: 'The instant within the period. Space stops the motion, arrows move it.',
    formula: 'u(x, t) = −(P(t + 1 + x) − P(t + 1 − x)), P the running sum of p.',
  },
  magnified: {
    title: 'Exaggeration',
    text: 'Displacements are magnified by this factor, or by as much as leaves every bar short of its clamp, its neighbours and the wall: the picture says by how much. At 1 it is to scale.',
    formula: 'drawn at x + M·u(x, t), with g/L = 10⁻³.',
  },
};

/** `at`: what on the screen the text speaks of. */
export interface TourStep { title: string; text: string; link: string; at: string }

export const tour: TourStep[] = [
  { title: 'One contact', at: '#bar-canvas', link: 'show=schedule&cells=300&phases=150:900&map=energy&magnified=100&pace=0.5',
    text: 'A bar, clamped on the left, swings along its axis and meets a wall once in a period. Red is compressed, blue is stretched; the wall lights up while it presses. This is the paper’s case, with the least energy it can have, 4 E₁.' },
  { title: 'Not one motion but a continuum', at: '#pause', link: 'show=schedule&cells=300&phases=150:900&energy=20&pause=0.25&map=energy&magnified=60&pace=0.5',
    text: 'Give it 20 E₁. Now there are infinitely many motions of the same period and the same energy: move the slider that is marked, and watch the push of the wall split in two. The set of all of them has 148 dimensions.' },
  { title: 'Families', at: '#map', link: 'show=schedule&cells=300&phases=120:880&map=energy&magnified=60&pace=0.5',
    text: 'Every blue half-line of the map is such a family: three whole numbers say its period, contact and least energy. Point at any of them. Above ω₁ they crowd, up to 1.3 ω₁; between 2 ω₁ and 3 ω₁ there are none.' },
  { title: 'Between the grids', at: '#period', link: 'show=mode&cells=200&contact=4&turns=-1&period=3.141592653589793&map=energy&magnified=60&pace=0.5',
    text: 'Black curves are modes: a motion for every period, here T = π. The waves are of one size and change sign at a few instants; there the continuum has shrunk to a single motion.' },
  { title: 'Pluck it', at: '#release', link: 'show=simulation&cells=200&start=1:-3&dashpot=0&crossings=40&from=0&span=16&map=existence&magnified=60&pace=0.8',
    text: 'Pull the bar away from the wall and let go. It is followed exactly, event by event: no time step, no law of restitution. Drag the bar itself for another try. The map now shows for which contact and flight times periodic motions exist at all.' },
  { title: 'Forced resonance', at: '#start-beside', link: 'show=forced&cells=60&phases=24:192&which=1&damping=0.02&place=tip&amplitude=0.0002&grid=60&least=0.8&most=1.4&map=response&magnified=30&pace=0.8',
    text: 'Shake it: a harmonic force on the tip, a little damping. All motions with one contact in a period are dots of the map; full ones attract, open ones repel. Perturb this motion and see where the bar settles, or sweep the frequency up and down.' },
  { title: 'Several bars', at: '#parts', link: 'show=scene&words=clamp+100+gap%3D1e-3+140%3A1.3+clamp&hands=-4:2&from=0&span=16&map=energy&magnified=60&pace=0.8',
    text: 'Last, build your own: bars, walls, springs, dashpots. Drag a bar, a wall, or the parts that are marked; each front of a wave is followed through all of them.' },
];
