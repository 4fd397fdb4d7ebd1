// The page in one object: what is shown, and how each part follows it.

import uPlot from 'uplot';
import { BarView, Film } from './bar';
import { palette, tones } from './colours';
import { Latest, type Answer, type Library, type Motion, type Question } from './core';
import { byId, input, shown } from './dom';
import { Atlas, MapView, type Pick, type ResponsePoint } from './map';
import { showFacts } from './panels';
import { Plot } from './plots';
import { Polygons } from './polygons';
import { SurfaceView } from './surface';
import { polygonOrder } from './takeaway';
import { asLink, fromLink, whatOf, type MapKind, type View } from './view';

const usualGap = 1e-3;  // [m], of the bar of the page
const atlasQuestion = { show: 'map', cells: 300, order: 60, energy: 60 };

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
    velocity: new Plot(byId('velocity')), settling: new Plot(byId('settling')) };
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
    this.asked = this.view.motion;
    this.map = new MapView(byId('map'), (pick) => void this.pick(pick));
    addEventListener('hashchange', () => this.follow(location.hash));
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

  follow(link: string): void {
    this.view = this.read(link);
    this.showMap(this.view.map);
    void this.show(this.view.motion, true);
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
        this.view.motion = motion;
        this.answer = answer;
        this.film = answer.has('u') ? new Film(answer) : undefined;
        this.showAnswer(motion, answer);
      } catch (fault) {
        this.say(`${(fault as Error).message}. What is shown stays as it was.`);
        if (!this.answer) {
          this.view = fromLink('').view;
          const answer = await this.library.ask(this.view.motion as unknown as Question);
          this.answer = answer;
          this.film = new Film(answer);
          this.showAnswer(this.view.motion, answer);
        }
        if (this.asked === motion) this.asked = this.view.motion;
        this.onShown();
      }
    });
  }

  private showAnswer(motion: Motion, answer: Answer): void {
    this.bar.film = this.film;
    this.bar.pluck = undefined;
    this.bar.magnified = this.view.magnified;
    this.bar.gap = motion.show === 'schedule' ? (motion.gap ?? usualGap) / usualGap : 1;
    this.bar.stop = motion.show === 'schedule' && motion.second_stop !== undefined ? motion.second_stop / usualGap : undefined;
    showFacts(motion, answer);
    if (this.film) {
      this.surface.show(this.film);
      this.showTraces(this.film, answer);
    }
    this.showSettling(motion, answer);
    this.map.setHere(this.here());
    this.setTime(this.view.time);
    if (performance.getEntriesByName('first-motion').length === 0) performance.mark('first-motion');
    this.keepLink();
    this.onShown();
  }

  private showTraces(film: Film, answer: Answer): void {
    const { ink } = tones();
    const line = (stroke: string, isStepped: boolean): uPlot.Series => ({
      stroke, width: 2, points: { show: false }, ...(isStepped ? { paths: uPlot.paths.stepped!({ align: 1 }) } : {}),
    });
    this.plots.tip.show({ x: 'time t [L/c]', y: 'tip u(L, t) [g]' }, [film.times, film.tip()], [line(ink, false)], (plot) => {
      plot.ctx.strokeStyle = palette.faint;
      plot.ctx.lineWidth = 2 * devicePixelRatio;
      plot.ctx.setLineDash([6, 4]);
      for (const place of [this.bar.gap, ...(this.bar.stop === undefined ? [] : [-this.bar.stop])]) {
        const y = plot.valToPos(place, 'y', true);
        plot.ctx.beginPath();
        plot.ctx.moveTo(plot.bbox.left, y);
        plot.ctx.lineTo(plot.bbox.left + plot.bbox.width, y);
        plot.ctx.stroke();
      }
      plot.ctx.setLineDash([]);
    });
    this.plots.force.show({ x: 'time t [L/c]', y: 'force [EA g/L]' }, [film.times, film.force],
      [{ ...line(palette.contact, true), fill: `${palette.contact}33` }]);
    byId('initial-card').hidden = !answer.has('s0');
    if (answer.has('s0')) {
      const x = answer.array('x');
      this.plots.strain.show({ x: 'place x [L]', y: 'strain s [g/L]', xRange: [0, 1] }, [x, answer.array('s0')], [line(palette.strain, true)]);
      this.plots.velocity.show({ x: 'place x [L]', y: 'velocity v [c g/L]', xRange: [0, 1] }, [x, answer.array('v0')], [line(palette.velocity, true)]);
    }
  }

  private showSettling(motion: Motion, answer: Answer): void {
    const host = byId('settling');
    host.hidden = !(motion.show === 'simulation' && answer.has('impulses'));
    if (host.hidden) return;
    const impulses = answer.array('impulses');
    this.plots.settling.show({ x: 'periods of the excitation', y: 'impulse [EA g/c]' },
      [Float64Array.from(impulses, (_, k) => k + 1), impulses], [{ stroke: palette.strain, width: 1.5, points: { show: false } }]);
  }

  /** Where the motion is on the map. */
  private here(): { x: number; y: number } | undefined {
    const motion = this.view.motion;
    const a = this.answer?.json.answer as Record<string, any> | undefined;
    if (!a || (motion.show === 'schedule' && (motion.gap !== undefined || motion.second_stop !== undefined))) return undefined;
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
    this.map.setHere(this.here());
    byId('forcing').hidden = kind !== 'response';
    byId('map-legend').textContent = {
      energy: 'Black curves: modes, a motion for every period. Blue half-lines: families, each a continuum; a dot is their least energy. The ring is what you see.',
      existence: 'A dot for each schedule of 300 cells that has a motion: dark for little energy, bright for much; grey ones only touch the wall. Each tent is one family.',
      contacts: 'Two contacts in a period, on no grid. Filled: polygons; at one period their motions divide the contact time between the two contacts freely, at one energy. Dashed: at each period a single motion. Drag the ring.',
      response: 'A dot for each motion with one contact in a period. Full: tested, it attracts; open: it repels, or was not tested yet. Grey: without a wall the bar would not reach it.',
    }[kind];
    if (kind === 'response') void this.loadResponse();
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
          count: stability ? 1 : 8 });
        if (run !== this.responseRun) return;
        [done, all] = [Number(answer.json.done), Number(answer.json.all)];
        const rows = answer.array('motions');
        for (let i = 0; i < rows.length; i += 6) {
          const last = points[points.length - 1];
          const which = last && last.steps === rows[i] && last.contact === rows[i + 2] ? 1 : 0;
          points.push({ steps: rows[i], frequency: rows[i + 1], contact: rows[i + 2], impulse: rows[i + 3], stays: rows[i + 5], which });
        }
        const places = answer.array('lines');
        for (let i = 0; i < places.length; i += 4) seen.push([places[i + 1], places[i + 2], places[i + 3]]);
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
    byId('time-value').textContent = `${shown(t, 4)} L/c`;
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
      const link = `#${asLink(this.view)}`;
      const isEntry = this.isChoice && location.hash !== '' && whatOf(link) !== whatOf(location.hash);
      this.isChoice = false;
      history[isEntry ? 'pushState' : 'replaceState'](null, '', link);
    }, 150);
  }

  recolour(): void {
    this.bar.recolour();
    this.bar.paint();
    this.surface.recolour();
    this.showMap(this.view.map);
    if (this.answer && this.film) this.showTraces(this.film, this.answer);
    if (this.answer) this.showSettling(this.view.motion, this.answer);
    this.setTime(this.view.time);
  }
}
