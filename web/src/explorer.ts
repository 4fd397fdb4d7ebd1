// The page in one object: what is shown, and how each part follows it.

import uPlot from 'uplot';
import { BarView, Film } from './bar';
import { palette, tones } from './colours';
import { Latest, type Answer, type Library, type Motion, type Question } from './core';
import { byId, input } from './dom';
import { Atlas, MapView, mostEnergy, type Pick, type ResponsePoint } from './map';
import { headlineOf, showFacts } from './panels';
import { Plot, trace } from './plots';
import { Polygons } from './polygons';
import { Sweeps } from './sweeps';
import { SurfaceView } from './surface';
import { polygonOrder } from './takeaway';
import { units, withUnit, type System } from './units';
import { asLink, fromLink, whatOf, type MapKind, type View } from './view';

const usualGap = 1e-3;  // [m], of the bar of the page
const atlasQuestion = { show: 'map', cells: 300, order: 60, energy: mostEnergy };

export class Explorer {
  view: View;
  /** The motion last asked for: the one in `view`, once it is on the screen or refused. */
  asked: Motion;
  answer: Answer | undefined;
  film: Film | undefined;
  isPlaying = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  readonly bar = new BarView(byId<HTMLCanvasElement>('bar-canvas'));
  readonly surface = new SurfaceView(byId<HTMLCanvasElement>('surface'), byId('surface-host'));
  readonly map: MapView;
  readonly plots = { tip: new Plot(byId('tip')), force: new Plot(byId('force')), strain: new Plot(byId('strain')),
    velocity: new Plot(byId('velocity')), settling: new Plot(byId('settling')), faces: new Plot(byId('faces')), pushes: new Plot(byId('pushes')) };
  readonly sweeps: Sweeps;
  /** Called when a motion is on the screen: the controls follow. */
  onShown: () => void = () => undefined;
  private readonly motions = new Latest();
  private linkFault: string | undefined;
  private responseRun = 0;
  private linkTimer = 0;
  private isChoice = false;  // what the reader did last: chosen, not dragged
  private lastFrame = 0;
  private frames = 0;

  constructor(readonly library: Library) {
    this.view = this.read(location.hash);
    units.system = this.view.units;
    this.asked = this.view.motion;
    this.map = new MapView(byId('map'), (pick) => void this.pick(pick));
    this.sweeps = new Sweeps(this);
    addEventListener('hashchange', () => void this.follow(location.hash));
    const isDragged = (event: Event): boolean => event.target instanceof HTMLInputElement && event.target.type === 'range';
    for (const kind of ['click', 'change', 'submit', 'input']) {
      addEventListener(kind, (event) => { this.isChoice = !isDragged(event); }, { capture: true });
    }
    requestAnimationFrame((now) => this.frame(now));
  }

  async begin(): Promise<void> {
    await this.show(this.view.motion);
    const answer = await this.library.ask(atlasQuestion);
    this.map.atlas = new Atlas(answer, atlasQuestion.cells);
    this.showMap(this.view.map);
    this.onShown();
  }

  follow(link: string): Promise<void> {
    const { motion, ...rest } = this.read(link);
    this.view = { ...rest, motion: this.view.motion };
    this.asked = motion;
    units.system = this.view.units;
    this.showMap(this.view.map);
    return this.show(motion, true);
  }

  /** The view of a link; what was wrong with it is said when its motion is shown. */
  private read(link: string): View {
    const { view, fault } = fromLink(link);
    this.linkFault = fault;
    return view;
  }

  say(text: string | undefined): void {
    byId('notice').hidden = !text;
    byId('notice').textContent = text ?? '';
  }

  /** Asks the library and shows what it answers; a fault becomes a sentence. */
  show(motion: Motion, keepsTime = false): Promise<void> {
    this.asked = motion;
    return this.motions.run(async () => {
      try {
        const answer = await this.library.ask(motion as unknown as Question);
        this.say(this.linkFault);
        this.linkFault = undefined;
        if (motion.show !== this.view.motion.show && !keepsTime) this.view.time = 0;
        this.take(motion, answer);
      } catch (fault) {
        this.say(`${(fault as Error).message}. ${this.answer ? 'What is shown stays as it was.' : 'The paper’s case is shown instead.'}`);
        if (!this.answer) {
          this.view = fromLink('').view;
          this.take(this.view.motion, await this.library.ask(this.view.motion as unknown as Question));
        }
        if (this.asked === motion) this.asked = this.view.motion;
        this.onShown();
      }
    });
  }

  private take(motion: Motion, answer: Answer): void {
    this.view.motion = motion;
    this.answer = answer;
    const { gap, second_stop: stop } = motion.show === 'schedule' ? motion : {};
    this.film = answer.has('u') ? new Film(answer, (gap ?? usualGap) / usualGap, stop === undefined ? undefined : stop / usualGap) : undefined;
    this.showAnswer(motion, answer);
  }

  private showAnswer(motion: Motion, answer: Answer): void {
    this.bar.film = this.film;
    this.bar.pluck = undefined;
    this.bar.magnified = this.view.magnified;
    showFacts(motion, answer);
    const isScene = motion.show === 'scene';
    byId('map-card').hidden = isScene;
    byId('faces-card').hidden = !isScene;
    for (const part of document.querySelectorAll<HTMLElement>('[data-curves]')) part.hidden = isScene;
    byId('initial-card').hidden = !answer.has('s0');
    if (this.film) this.showCurves(this.film, answer);
    this.showSettling(motion, answer);
    this.map.setHere(this.here());
    this.setTime(this.view.time);
    if (performance.getEntriesByName('first-motion').length === 0) performance.mark('first-motion');
    this.keepLink();
    this.onShown();
  }

  /** The motion on the screen stays beside those to come; without one beside, that goes. */
  keepBeside(): void {
    const { answer, film, bar } = this;
    bar.kept = bar.kept || !film || !answer ? undefined : { film, name: headlineOf(this.view.motion, answer).replace(/\.$/, '') };
    bar.paint();
    if (film && answer) this.showCurves(film, answer);
    this.onShown();
  }

  useUnits(system: System): void {
    units.system = this.view.units = system;
    this.redraw();
    this.keepLink();
  }

  private showCurves(film: Film, answer: Answer): void {
    if (film.isScene) return this.showFaces(film);
    this.surface.show(film);
    const { ink } = tones();
    const line = (stroke: string, isStepped: boolean, width = 2): uPlot.Series => ({
      stroke, width, points: { show: false }, ...(isStepped ? { paths: uPlot.paths.stepped!({ align: 1 }) } : {}),
    });
    const kept = this.bar.kept?.film;
    // The kept motion at the same times, as often as it fits.
    const beside = (of: 'tip' | 'force'): Float64Array[] => (kept && !kept.isScene ? [film.pathTimes.map((t) => {
      const share = ((t - film.begin) / (kept.end - kept.begin)) % 1;
      return kept[of][Math.min(Math.floor(share * (kept.pathTimes.length - 1)), kept.pathTimes.length - 1)];
    })] : []);
    const grey = (isStepped: boolean): uPlot.Series[] => (kept && !kept.isScene ? [line(palette.faint, isStepped, 1.5)] : []);
    this.plots.tip.show({ x: ['time t', 'time'], y: ['tip u(L, t)', 'displacement'] }, [film.pathTimes, film.tip, ...beside('tip')], [line(ink, false), ...grey(false)], (plot) => {
      plot.ctx.strokeStyle = palette.faint;
      plot.ctx.lineWidth = 2 * devicePixelRatio;
      plot.ctx.setLineDash([6, 4]);
      for (const { kind, gap } of film.contacts) {
        const y = plot.valToPos(kind === 'left stop' ? -gap : gap, 'y', true);
        trace(plot.ctx, 'stroke', [plot.bbox.left, y], [plot.bbox.left + plot.bbox.width, y]);
      }
      plot.ctx.setLineDash([]);
    });
    this.plots.force.show({ x: ['time t', 'time'], y: ['force', 'force'] }, [film.pathTimes, film.force, ...beside('force')],
      [{ ...line(palette.contact, true), fill: `${palette.contact}33` }, ...grey(true)]);
    if (answer.has('s0')) {
      const x = answer.array('x');
      this.plots.strain.show({ x: ['place x', 'place'], y: ['strain s', 'strain'], xRange: [0, 1] }, [x, answer.array('s0')], [line(palette.strain, true)]);
      this.plots.velocity.show({ x: ['place x', 'place'], y: ['velocity v', 'velocity'], xRange: [0, 1] }, [x, answer.array('v0')], [line(palette.velocity, true)]);
    }
  }

  /** Of several bars: the faces that may touch, counted from the first one of each pair, and how they press. */
  private showFaces(film: Film): void {
    const colours = [palette.strain, palette.contact, palette.velocity, palette.faint];
    const at = (node: number): Float64Array => film.times.map((_, m) => film.u[m * film.nodes + node]);
    const lines = film.contacts.flatMap(({ kind, at: node, next, gap }, k) => {
      const stroke = colours[k % colours.length];
      const wall = next === null ? film.times.map(() => (kind === 'left stop' ? -gap : gap)) : at(next).map((u) => u + gap);
      return [{ values: at(node), series: { stroke, width: 2, points: { show: false } } }, { values: wall, series: { stroke, width: 1.5, dash: [6, 4], points: { show: false } } }];
    });
    this.plots.faces.show({ x: ['time t', 'time'], y: ['faces', 'displacement'] }, [film.times, ...lines.map((one) => one.values)], lines.map((one) => one.series));
    const pushes = film.contacts.map((_, k) => film.times.map((__, m) => film.forces[m * film.contacts.length + k]));
    this.plots.pushes.show({ x: ['time t', 'time'], y: ['force', 'force'] }, [film.times, ...pushes],
      pushes.map((_, k) => ({ stroke: colours[k % colours.length], width: 1.5, points: { show: false }, paths: uPlot.paths.stepped!({ align: 1 }) })));
    byId('faces-legend').textContent = 'Full: the node at a contact; dashed: what it may meet. Below: how hard they press.';
  }

  private showSettling(motion: Motion, answer: Answer): void {
    const host = byId('settling');
    host.hidden = !(motion.show === 'simulation' && answer.has('impulses'));
    if (host.hidden) return;
    const impulses = answer.array('impulses');
    this.plots.settling.show({ x: ['periods of the excitation', 'count'], y: ['impulse', 'impulse'] },
      [Float64Array.from(impulses, (_, k) => k + 1), impulses], [{ stroke: palette.strain, width: 1.5, points: { show: false } }]);
  }

  /** Where the motion is on the map. */
  private here(): { x: number; y: number } | undefined {
    const motion = this.view.motion;
    const a = this.answer?.json.answer as Record<string, any> | undefined;
    if (!a || motion.show === 'scene' || (motion.show === 'schedule' && (motion.gap !== undefined || motion.second_stop !== undefined))) return undefined;
    if (this.view.map === 'energy' && typeof a.energy_ratio === 'number' && typeof a.frequency_ratio === 'number') {
      return { x: a.frequency_ratio, y: a.energy_ratio };
    }
    if (this.view.map === 'contacts' && motion.show === 'polygon') {
      return { x: motion.period, y: (a.stretches as number[])[0] };
    }
    if (this.view.map === 'existence' && motion.show === 'schedule' && motion.phases.length === 1) {
      return { x: motion.phases[0][0] / motion.cells, y: motion.phases[0][1] / motion.cells };
    }
    if (this.view.map === 'existence' && motion.show === 'mode') {
      return { x: a.contact_time_ratio, y: a.period_ratio - a.contact_time_ratio };
    }
    if (this.view.map === 'response' && motion.show === 'forced' && a.status === 'found') {
      return { x: a.frequency_ratio, y: a.motions[Number(this.answer!.json.which)].impulse / 1e-3 };
    }
    return undefined;
  }

  showMap(kind: MapKind): void {
    this.view.map = kind;
    this.map.show(kind, this.view);
    byId('forcing').hidden = kind !== 'response' || this.view.motion.show === 'scene';
    this.map.setHere(this.here());
    byId('map-legend').textContent = byId('map-key').textContent = {
      energy: 'Black curves: modes, a motion for every period. Blue half-lines: families, each a continuum; a dot is their least energy. Ring: what you see. The axis is spread near ω₁.',
      existence: 'A dot for each schedule of 300 cells that has a motion: dark for little energy, bright for much; grey: it only touches the wall. Each tent is one family.',
      contacts: 'Filled: polygons, whose motions divide the contact time between two contacts freely, at one energy. Dashed: at each period a single motion. Drag the ring.',
      response: 'Each dot is a motion with one contact in a period: ● tried, it attracts; ○ tried, it repels; · not tried. ▲▼ a sweep. Grey: without a wall the bar would not reach it.',
    }[kind];
    if (kind === 'response') void this.loadResponse();
    else this.sweeps.stop();
    if (kind === 'contacts' && !this.map.polygons) void this.loadPolygons();
    this.keepLink();
  }

  private async loadPolygons(): Promise<void> {
    this.map.polygons = new Polygons(await this.library.ask({ show: 'polygons', order: polygonOrder }));
    if (this.view.map === 'contacts') this.map.show('contacts', this.view);
    this.onShown();
  }

  /** The response, at first all of it, then once more with trials of what attracts. */
  async loadResponse(): Promise<void> {
    const run = ++this.responseRun;
    const { damping, place, amplitude, cells, least, most } = this.view.forcing;
    const { response, lines } = this.map;
    for (const stability of [false, true]) {
      const points: ResponsePoint[] = [];
      const seen: [number, number, number][] = [];
      for (let done = 0, all = 1; done < all; ) {
        const answer = await this.library.ask({ show: 'response', cells, damping, place, amplitude, least, most, stability, done,
          count: stability ? 1 : 8 }).catch((fault: Error) => { byId('progress').textContent = `${fault.message}.`; });
        if (!answer || run !== this.responseRun) return;
        [done, all] = [Number(answer.json.done), Number(answer.json.all)];
        const rows = answer.array('motions');
        for (let i = 0; i < rows.length; i += 5) {
          const last = points[points.length - 1];
          const which = last && last.steps === rows[i] && last.contact === rows[i + 2] ? 1 : 0;
          points.push({ steps: rows[i], frequency: rows[i + 1], contact: rows[i + 2], impulse: rows[i + 3], stays: rows[i + 4], which });
        }
        const places = answer.array('lines');
        for (let i = 0; i < places.length; i += 3) seen.push([places[i], places[i + 1], places[i + 2]]);
        byId('progress').textContent = done < all ? `${stability ? 'testing stability' : 'computing'}: ${done} of ${all} frequencies`
          : `${points.length} motions at ${all} frequencies${stability ? ', each tried' : ''}`;
        if (!stability || done === all) {
          response.splice(0, response.length, ...points);
          lines.splice(0, lines.length, ...seen);
          if (this.view.map === 'response') this.map.showResponse(this.view.forcing);
          this.map.setHere(this.here());
        }
      }
    }
  }

  /** A sweep has the library to itself. */
  haltResponse(): void { ++this.responseRun; }

  async pick(pick: Pick): Promise<void> {
    if (pick.kind === 'family') {
      const { order, nu, blocks, least } = pick.family;
      const place = await this.library.ask({ show: 'family', order, nu, blocks, cells: 300 });
      const motion: Motion = { show: 'schedule', cells: Number(place.json.cells), phases: place.json.phases as [number, number][] };
      if (pick.energy > 1.02 * least) motion.energy = Number(pick.energy.toPrecision(4));
      await this.show(motion);
    } else if (pick.kind === 'mode') {
      const [contact, turns] = pick.mode.contact;
      await this.show({ show: 'mode', contact, turns, period: Number(pick.period.toPrecision(8)), cells: 200 });
    } else if (pick.kind === 'polygon') {
      await this.show({ show: 'polygon', chains: pick.polygon.chains, period: pick.period, split: pick.split, cells: 200 });
    } else if (pick.kind === 'schedule') {
      await this.show({ show: 'schedule', cells: atlasQuestion.cells, phases: pick.phases });
    } else {
      const { damping, place, amplitude, cells } = this.view.forcing;
      const { contact, steps, which } = pick.point;
      await this.show({ show: 'forced', cells, phases: [[contact, steps - contact]], damping, place, amplitude, which });
    }
  }

  /** A share of the period. */
  setTime(share: number): void {
    this.view.time = share;
    this.bar.share = share;
    this.bar.paint();
    this.surface.setCursor(share);
    const { film } = this;
    if (!film) return;
    const t = film.begin + share * (film.end - film.begin);
    this.plots.tip.setCursor(t);
    this.plots.force.setCursor(t);
    input('time').value = String(share);
    byId('time-value').textContent = withUnit('time', t, 4);
  }

  /** All once more, in other colours, units or letters. */
  redraw(): void {
    this.bar.recolour();
    this.surface.recolour();
    this.showMap(this.view.map);
    if (this.answer) this.showAnswer(this.view.motion, this.answer);
    this.sweeps.mark();
  }

  private frame(now: number): void {
    const begin = performance.now();
    const passed = Math.min((now - this.lastFrame) / 1000, 0.1);
    this.lastFrame = now;
    if (this.isPlaying && this.film && !this.bar.pluck) {
      this.setTime((this.view.time + (passed * this.view.pace) / (this.film.end - this.film.begin)) % 1);
      performance.measure('frame', { start: begin });
      if (++this.frames % 600 === 0) performance.clearMeasures('frame');
    }
    requestAnimationFrame((next) => this.frame(next));
  }

  setPlaying(isPlaying: boolean): void {
    this.isPlaying = isPlaying;
    byId('play').textContent = isPlaying ? 'Pause' : 'Play';
    if (!isPlaying) this.keepLink();
  }

  /**
   * The address follows a moment later, so that dragging does not write it a hundred times. Another
   * motion or map that was chosen is an entry of its own, to which Back leads; what is dragged is not.
   */
  keepLink(): void {
    clearTimeout(this.linkTimer);
    this.linkTimer = window.setTimeout(() => {
      const link = `#${asLink({ ...this.view, motion: this.asked })}`;
      const isEntry = this.isChoice && location.hash !== '' && whatOf(link) !== whatOf(location.hash);
      this.isChoice = false;
      history[isEntry ? 'pushState' : 'replaceState'](null, '', link);
    }, 150);
  }
}
