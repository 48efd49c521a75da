// A scene in MuJoCo of npm.
import { join } from "node:path";
import { pathToFileURL } from "node:url";

/** Processor time of this process [ms]: other work of the machine can hardly add to it. */
export function clock() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

/** @param npm folder with node_modules */
export async function loadMujoco(npm) {
  return (await import(pathToFileURL(join(npm, "node_modules/@mujoco/mujoco/mujoco.js")))).default();
}

const distance = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

/** One model of a scene. A family is an integrator and, where loops are closed, the softness of their constraints; its
    settings are the numbers of steps, each twice that before. */
export class Mujoco {
  /** @throws if the model does not have the energies and accelerations of the scene */
  constructor(mujoco, scene, { hinges, text, rates }) {
    Object.assign(this, { mujoco, scene, hinges, rates });
    this.has_springs = text.includes("<spatial");
    this.model = mujoco.MjModel.from_xml_string(text);
    this.data = new mujoco.MjData(this.model);
    this.option = this.model.opt;
    this.body = this.idOf(scene.body);
    this.option.disableflags |= this.needless();
    this.families = this.allFamilies();
    this.takeViews();
    this.difference = this.compare();
  }

  idOf(body) { return this.mujoco.mj_name2id(this.model, this.mujoco.mjtObj.mjOBJ_BODY.value, `b${body}`); }

  /** Everything that costs time and that this scene does not need. Without "refsafe", time constants may be below two
      steps. Without "autoreset", a run that fails does not begin again. */
  needless() {
    const none = this.scene.loops > 0 ? [] : ["CONSTRAINT", "EQUALITY", "ISLAND", "WARMSTART"];
    if (!this.has_springs) { none.push("SPRING", "DAMPER"); }
    none.push("FRICTIONLOSS", "LIMIT", "CONTACT", "CLAMPCTRL", "ACTUATION", "SENSOR", "MIDPHASE", "REFSAFE", "AUTORESET");
    return none.reduce((flags, name) => flags | this.mujoco.mjtDisableBit[`mjDSBL_${name}`].value, 0);
  }

  allFamilies() {
    const soft = [2, 1.4, 1, 0.7, 0.5].flatMap((steps) => [0.5, 1, 2].flatMap((damping) =>
      [false, true].map((exact) => ({ steps, damping, exact }))));
    // of the others, none is of an order that balls could spoil
    const integrators = this.hinges ? ["RK4"] : ["RK4", "EULER", "IMPLICIT", "IMPLICITFAST", "DISCRETE"];
    return integrators.flatMap((integrator) => (this.scene.loops > 0 ? soft : [undefined]).map((loops) =>
      ({ integrator, loops, name: integrator + (this.hinges && " with hinges") })));
  }

  setting(family, k) { return { family, steps: k < 3 ? [20, 40, 60][k] : 100 * 2 ** (k - 3) }; }
  exists({ steps }) { return steps < 1e9; }

  /** Settings between this and the next coarser one of its family. */
  between({ family, steps }) {
    const unit = steps > 1600 ? 100 : 20;
    const numbers = [9, 10, 11, 12, 13, 14, 15].map((k) => unit * Math.round((steps * k) / (16 * unit)));
    return [...new Set(numbers)].filter((n) => n > steps / 2 && n < steps).map((n) => ({ family, steps: n }));
  }

  text({ family, steps }) {
    const loops = family.loops;
    const soft = loops ? `, solref ${loops.steps} dt ${loops.damping}${loops.exact ? ", diagexact" : ""}` : "";
    const balls = this.hinges && `, balls as hinges ${this.hinges}`;
    return `${family.integrator}${balls}, dt ${(this.scene.duration / steps).toExponential(1)}${soft}`;
  }

  /** Options of a run, whose cost is not counted. */
  prepare({ family, steps }) {
    const { mujoco, model, option } = this;
    option.integrator = mujoco.mjtIntegrator[`mjINT_${family.integrator}`].value;
    option.timestep = this.scene.duration / steps;
    const exact = mujoco.mjtEnableBit.mjENBL_DIAGEXACT.value;
    option.enableflags = family.loops?.exact ? option.enableflags | exact : option.enableflags & ~exact;
    for (let k = 0; k < model.neq; ++k) {
      model.eq_solref.set([family.loops.steps * option.timestep, family.loops.damping], 2 * k);
      // as stiff as can be
      model.eq_solimp.set([0.9999, 0.9999], 5 * k);
    }
    this.takeViews();
  }

  /** Arrays of the engine's memory, which moves when it grows. */
  takeViews() {
    const { qvel, xfrc_applied, xpos, xmat } = this.data;
    this.views = { qvel, xfrc_applied, xpos, xmat };
    this.starts = this.rates.map(([body, rates]) => [this.model.body_dofadr[this.idOf(body)], rates]);
  }

  start() {
    this.mujoco.mj_resetData(this.model, this.data);
    for (const [first, rates] of this.starts) { if (rates.length > 0) { this.views.qvel.set(rates, first); } }
    for (const [body, force, torque] of this.scene.wrenches) { this.views.xfrc_applied.set([...force, ...torque], 6 * this.idOf(body)); }
  }

  /** Distance of the point from the reference [m] at a sample. */
  distanceAt(sample) {
    this.mujoco.mj_kinematics(this.model, this.data);
    const { xpos, xmat } = this.views;
    const [x, y, z] = this.scene.point;
    const reference = this.scene.reference[sample];
    let sum = 0;
    for (let k = 0; k < 3; ++k) {
      const row = 9 * this.body + 3 * k;
      sum += (xpos[3 * this.body + k] + xmat[row] * x + xmat[row + 1] * y + xmat[row + 2] * z - reference[k]) ** 2;
    }
    return Math.sqrt(sum);
  }

  /** Compares the point at the samples that steps meet: all 100, or at least 20 of them where steps are few.
      @returns largest distance from the reference [m]; infinite if that is more than 1e-3, or the run takes longer */
  run({ steps }, milliseconds) {
    const end = clock() + milliseconds;
    const stride = [1, 2, 4, 5, 10].find((samples) => Number.isInteger((samples * steps) / 100));
    const parts = (stride * steps) / 100;
    const { mujoco, model, data } = this;
    this.start();
    let error = 0;
    for (let sample = stride; sample <= 100; sample += stride) {
      for (let k = 0; k < parts; ++k) { mujoco.mj_step(model, data); }
      error = Math.max(error, this.distanceAt(sample));
      if (!(error <= 1e-3) || clock() > end) { return Infinity; }
    }
    return error;
  }

  /** Differences from the scene at the start, relative: of the energies, and of the accelerations of all bodies. Constraints of
      loops are soft, so that accelerations differ by the share that they give way. */
  compare() {
    const { mujoco, model, data, option, scene } = this;
    option.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY.value;
    this.prepare({ family: this.families[0], steps: 1e4 });
    this.start();
    mujoco.mj_forward(model, data);
    mujoco.mj_rnePostConstraint(model, data);
    const size = Math.max(1e-3, Math.abs(scene.kinetic), Math.abs(scene.potential));
    const energy = distance(Array.from(data.energy), [scene.potential, scene.kinetic]) / size;
    option.enableflags &= ~mujoco.mjtEnableBit.mjENBL_ENERGY.value;
    const found = new mujoco.DoubleBuffer(6);
    const largest = [0, 1].map((kind) => Math.max(...scene.accelerations.map((of) => Math.hypot(...of[kind]))));
    let acceleration = 0;
    for (const [body] of this.rates) {
      mujoco.mj_objectAcceleration(model, data, mujoco.mjtObj.mjOBJ_BODY.value, this.idOf(body), found, 0);
      const [a, b, c, x, y, z] = found.GetView();
      // the engine counts as an accelerometer does
      const linear = [x, y, z].map((value, k) => value + scene.gravity[k]);
      const off = [distance(linear, scene.accelerations[body][0]), distance([a, b, c], scene.accelerations[body][1])];
      acceleration = Math.max(acceleration, ...off.map((value, kind) => value / (largest[kind] || 1)));
    }
    found.delete();
    if (!(energy < 1e-9 && acceleration < (scene.loops > 0 ? 1e-2 : 1e-6))) {
      throw new Error(`${scene.name}: the models differ: energies by ${energy}, accelerations by ${acceleration}`);
    }
    return { energy, acceleration };
  }

  compared() {
    const { energy, acceleration } = this.difference;
    return `energies at the start differ by ${energy.toExponential(0)}, accelerations by ${acceleration.toExponential(0)}`;
  }

  /** The order of RK4, by the last two errors that are above rounding. @throws if errors of trees of hinges end too early */
  order(tried) {
    if (this.scene.loops > 0) { return "not asked, loops are soft"; }
    const { rows } = tried.find(({ family }) => family.integrator === "RK4");
    const [a, b] = rows.filter((row) => row.error > 2e-10 && row.error < 1e-3).slice(-2);
    if (!b) { return "not seen"; }
    const order = Math.log2(a.error / b.error) / Math.log2(b.setting.steps / a.setting.steps);
    if (this.scene.models.length === 1 && !(order > 3.5)) {
      throw new Error(`${this.scene.name}: RK4 has the order ${order}: it does not converge to the reference`);
    }
    return order.toFixed(1);
  }

  delete() {
    this.option.delete();
    this.data.delete();
    this.model.delete();
  }
}
