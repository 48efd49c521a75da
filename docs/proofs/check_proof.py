#!/usr/bin/python3
"""Checks a proof that 'jointwise solve LESSON --proof FILE' wrote: check_proof.py FILE; ../proofs.md describes the file.
Knows the equations of the book, intervals (intervals.py beside it) and the file, nothing else. For each step it shows
|M Phi(x^(t), t)| + |I - M J(x, t)| rho < rho for all times of the step and all x of the tube |x - x^(t)| <= rho about the
cubic path x^: exactly one solution lies in the tube. Where steps meet, it shows that their solutions are the same one.
Exit status: 0 yes, 1 no, 2 the file cannot be read."""
import hashlib, json, sys
from math import inf
from mpmath import iv

sys.dont_write_bytecode = True  # no folder of it among the docs
from intervals import AROUND, ONE, ZERO, Grad, Poly, Wrong, evaluated, total

LEAST_PIECE = 2.0**-6  # of a step: where its tube is not narrow enough for halves of halves, there is no proof
REPEATED_HOLD = iv.mpf(1e-6)  # at a pose, equations that repeat others: loops are typed with six digits
TWO = iv.mpf(2)

numbers = lambda values: [iv.mpf(x) for x in values]
dot = lambda u, v: u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
minus = lambda u, v: [x - y for x, y in zip(u, v)]
cross = lambda u, v: [u[k - 2] * v[k - 1] - u[k - 1] * v[k - 2] for k in range(3)]
weighted = lambda row, weights: total(abs(x) * weights[c] for c, x in row.items())


class Body:
    """Place r and Euler parameters p, with A = G L^T."""

    def __init__(self, r, p):
        self.r, self.p, self.A = r, p, [[None] * 3 for _ in range(3)]
        square = {(k, l): p[k] * p[l] for k in range(4) for l in range(k, 4)}
        for k, a, b in (1, 2, 3), (2, 3, 1), (3, 1, 2):
            ab, turn = square[min(a, b), max(a, b)], square[0, k]
            self.A[k - 1][k - 1] = square[0, 0] + square[k, k] - square[a, a] - square[b, b]
            self.A[a - 1][b - 1], self.A[b - 1][a - 1] = (ab - turn).times(TWO), (ab + turn).times(TWO)

    arm = lambda self, s: [row[0].times(s[0]) + row[1].times(s[1]) + row[2].times(s[2]) for row in self.A]
    point = lambda self, s: [x + y for x, y in zip(self.r, self.arm(s))]


def formula(f, t):
    if isinstance(t, Grad):  # time is known: no columns
        return Grad(formula(f, Poly(t.value)).c[0])
    return evaluated(f["steps"], {"t": t}, Poly).times(iv.mpf(f["unit"]))


def function_of_time(f, t, span):
    value = type(t)(ZERO)
    for c in reversed(f["polynomial"]):
        value = value * t + type(t)(iv.mpf(c))
    for amplitude, omega, phase in map(numbers, f["harmonics"]):
        value = value + (t.times(omega) + type(t)(phase)).sine_and_cosine()[0].times(amplitude)
    for first, last, start, end in map(numbers, f["smooth_steps"]):
        is_before, is_after = span[1] <= start, span[0] >= end
        if not (is_before or is_after or start <= span[0] and span[1] <= end):
            raise Wrong("it leads over a time at which a smooth step of a driver begins or ends")
        u = (t - type(t)(start)).times(ONE / (end - start)) if not (is_before or is_after) else type(t)(ONE * is_after)
        shape = u * u * u * ((u.times(6 * ONE) - type(t)(15 * ONE)) * u + type(t)(10 * ONE))
        value = value + type(t)(first) + shape.times(last - first)
    if "table" in f:  # piece k holds from time k - 1 to time k
        times = f["table"]["times"]
        k = sum(1 for x in times if x <= span[0])
        if k < len(times) and span[1] > times[k]:
            raise Wrong("it leads over a time of a driver's table")
        start, c = f["table"]["pieces"][k]
        u, sum_of_powers = t - type(t)(iv.mpf(start)), type(t)(ZERO)
        for coefficient in reversed(c):
            sum_of_powers = sum_of_powers * u + type(t)(iv.mpf(coefficient))
        value = value + sum_of_powers
    return value + formula(f["formula"], t) if "formula" in f else value


def phi(q, i, j, theta, t, span):
    """The components of an equation; `t` is of the kind of number that they are."""
    const, s_i = type(t), lambda: i.arm(q["s_i"])
    d = lambda at="B": minus(j.point(q[at + "_j"]), i.point(q[at + "_i"]))
    target = lambda: function_of_time(q["function"], t, span)
    def angle(other):  # from u_i to u_j about s_i: the sine of its difference from another one, or another form
        (sine, cosine), u, v = other.sine_and_cosine(), i.arm(q["u_i"]), j.arm(q["u_j"])
        across, along, form = dot(cross(u, v), s_i()), dot(u, v), q.get("form", "rotation")
        return [{"rotation": across * cosine - along * sine, "cosine": along - cosine, "sine": across - sine}[form]]
    def curve(u):
        phi = dot(i.arm(q["e_i"]), d("P")) - const(q["constant"]) - u.times(q["linear"])
        for k, (of_cosine, of_sine) in enumerate(map(numbers, q["harmonics"]), 1):
            sine, cosine = u.times(k * ONE).sine_and_cosine()
            phi = phi - cosine.times(of_cosine) - sine.times(of_sine)
        return [phi]
    def wheel(other):  # from the line of the wheels to u about s: the sine of its difference from another angle
        body, mark = (j, "_j") if q["of_j"] else (i, "_i")
        s, u, (sine, cosine) = body.arm(q["s" + mark]), body.arm(q["u"]), other.times(q["ratio"]).sine_and_cosine()
        e = {"centres": lambda: d("P"), "normal": lambda: cross(s_i(), j.arm(q["s_j"])), "rack": s_i}[q["line"]]()
        return [dot(cross(e, u), s) * cosine - dot(e, u) * sine]
    def of_author():  # name.component is a number of a formula; A_i.x is the first column of A_i
        vectors = {"s_i": s_i(), "s_j": j.arm(q["s_j"]), "u_i": i.arm(q["u_i"]), "u_j": j.arm(q["u_j"]), "d": d("P")}
        for n, body in ("i", i), ("j", j):
            vectors |= {"r_" + n: body.point(q["O_" + n]), f"r_{n}_P": body.point(q["P_" + n])}
            vectors |= {f"A_{n}.{c}": [row[k] for row in body.A] for k, c in enumerate("xyz")}
        numbers_of = {f"{name}.{c}": x for name, v in vectors.items() for c, x in zip("xyz", v)}
        return [evaluated(q["formula"], numbers_of, const)]
    return {
        "s": lambda: minus(i.point(q["P_i"]), j.point(q["P_j"])),
        "n1": lambda: [dot(s_i(), j.arm(q["s_j"]))],
        "n1 pair": lambda: [dot(i.arm(q[a]), j.arm(q["s_j"])) for a in ("a_i", "b_i")],
        "n2": lambda: [dot(s_i(), d())],
        "n2 j": lambda: [dot(j.arm(q["s_j"]), d())],
        "n2 pair": lambda: [dot(i.arm(q[a]), d()) for a in ("a_i", "b_i")],
        "p1": lambda: cross(s_i(), j.arm(q["s_j"])),
        "p2": lambda: cross(s_i(), d()),
        "distance": lambda: [dot(d("P"), d("P")) - const(q["length"] * q["length"])],
        "screw advance": lambda: [dot(s_i(), d()) - const(q["d_0"]) - (theta - const(q["theta_0"])).times(q["alpha"])],
        "screw angle": lambda: angle(theta),
        "wheel": lambda: wheel(theta),
        "on curve": lambda: curve(theta),
        "formula": of_author,
        "unit length": lambda: [dot(j.p, j.p) + j.p[3] * j.p[3] - const(ONE)],
        "angle": lambda: angle(target()),
        "displacement": lambda: [dot(s_i(), d()) - target()],
        "driven distance": lambda: [dot(d("P"), d("P")) - target() * target()],
        "coordinate": lambda: [(j.r + j.p)[q["coordinate"]] - target()],
        "theta": lambda: [theta - target()],
    }[q["kind"]]()


def require(left, right, what):
    if not left < right:
        raise Wrong(f"{what}: does not hold, {float(left.b):.4g} against {float(right.a):.4g}")


def defect_of(M, rows, own):
    """I - M J in the columns `own`, M J with either sign in the others."""
    if not len(M) == len(own) == len(rows) or any(len(m) != len(rows) for m in M):
        raise Wrong(f"there are {len(rows)} rows and {len(own)} columns, and an inverse of {len(M)} rows")
    E = [{c: ONE} for c in own]
    for m, e in zip(M, E):
        for factor, row in zip(m, rows):
            for c, x in row.items():
                e[c] = e.get(c, ZERO) - factor * x
    return E


class Proof:
    def __init__(self, data):
        self.name_of = [name for name, size in data["coordinates"] for _ in range(size)]
        self.place, self.size = {n: [c for c, m in enumerate(self.name_of) if m == n] for n in self.name_of}, len(self.name_of)
        vector = lambda x: numbers(x) if isinstance(x, list) and x and all(isinstance(c, float | int) for c in x) else x
        self.equations = [{k: iv.mpf(x) if isinstance(x, float) else vector(x) for k, x in q.items()} for q in data["equations"]]
        self.fixed = {name: numbers(x) for name, x in data["fixed"].items()}
        self.poses, self.steps, self.rank = (data[k] for k in ("poses", "steps", "rank"))
        self.free, self.repeated, self.left = self.size, 0.0, 0
        self.all_rows = [(e, k) for e, q in enumerate(data["equations"]) for k in q["components"]]
        if any(not len(pose["x"]) == len(pose["x_dot"]) == self.size for pose in self.poses):
            raise Wrong(f"a pose has not {self.size} coordinates")
        if {"p of " + q["j"] for q in self.equations if q["kind"] == "unit length"} != {n for n in self.place if n[:2] == "p "}:
            raise Wrong("not every body has an equation that keeps p at length 1")
        if [(s["from"], s["to"]) for s in self.steps] != [(k, k + 1) for k in range(len(self.poses) - 1)]:
            raise Wrong("steps do not lead from each pose to the next")

    def rows(self, which, x, t, span):
        """Components of equations at coordinates x; all numbers are of one kind."""
        value = lambda n: [type(t)(c) for c in self.fixed[n]] if n in self.fixed else [x[k] for k in self.place[n]]
        bodies = {n: Body(value("r of " + n), value("p of " + n)) for n in {self.equations[e][end] for e, _ in which for end in "ij"}}
        theta = lambda q: value(q["theta"])[0] if "theta" in q else None
        asked = {e: self.equations[e] for e, _ in which}
        found = {e: phi(q, bodies[q["i"]], bodies[q["j"]], theta(q), t, span) for e, q in asked.items()}
        return [found[e][k] for e, k in which]

    def check_rank(self):
        """At the first pose."""
        x, t = [Grad(iv.mpf(x), {k: ONE}) for k, x in enumerate(self.poses[0]["x"])], iv.mpf(self.poses[0]["t"])
        J = dict(zip(self.all_rows, (g.d for g in self.rows(self.all_rows, x, Grad(t), (t, t)))))
        rows, repeated = [tuple(r) for r in self.rank["rows"]], {tuple(r["row"]): r for r in self.rank["repeated"]}
        columns, M = self.rank["columns"], [numbers(m) for m in self.rank["inverse"]]
        for row in defect_of(M, [{c: J[r].get(c, ZERO) for c in columns} for r in rows], columns):
            require(weighted(row, dict.fromkeys(columns, ONE)), ONE, "rank, |I - inverse * minor| < 1")
        for which, r in repeated.items():
            terms = list(zip(rows, numbers(r["combination"]), strict=True))
            for c in range(self.size):
                off = abs(total(J[row].get(c, ZERO) * f for row, f in terms) - J[which].get(c, ZERO))
                require(off, iv.mpf(r["misfit"]), f"rank, {self.equations[which[0]]['name']} is a combination of others")
        if len(set(columns)) != len(columns) or sorted(rows + list(repeated)) != sorted(J):
            raise Wrong("rank, of some rows nothing is said, or twice")
        self.free = self.size - len(rows)
        misfit = max([r["misfit"] for r in repeated.values()], default=0.0)
        return f"at t = {float(t.a)} s {len(rows)} equations are independent; {len(repeated)} more repeat these up to {misfit:.2g}"

    def check_part(self, part, x, t, span, error):
        """Adds to `error`, the bounds of |x - x^| by columns of earlier parts. @return what joins the step with its neighbours"""
        own = [c for k in part["coordinates"] for c in self.place[k]]
        rho = {c: iv.mpf(r) for k, r in zip(part["coordinates"], part["rho"], strict=True) for c in self.place[k]}
        rows, M = [tuple(r) for r in part["rows"]], [numbers(m) for m in part["M"]]
        radius = dict.fromkeys(range(self.size), iv.mpf(inf)) | error | rho
        if not set(rows) <= set(self.all_rows) or set(own) & set(error) or len(rho) < len(own):
            raise Wrong("a part has rows that no equation has, or coordinates twice")
        kept = [dict(zip(own, numbers(w), strict=True)) for w in part.get("kept", [])]
        residual = self.rows(rows, x, t, span)
        misses = lambda of: [total(abs(f) * of(r) for f, r in zip(m, residual)) for m in M]
        alpha, image, pieces = misses(Poly.bound), dict.fromkeys(own, ZERO), [(-1.0, 1.0)]
        while pieces:
            first, last = pieces.pop()
            over = lambda f: f.range_over(iv.mpf(first + last) / 2, iv.mpf(last - first) / 2)
            box = [Grad(over(f) + AROUND * radius[c], {c: ONE}) for c, f in enumerate(x)]
            E = defect_of(M, [g.d for g in self.rows(rows, box, Grad(over(t)), span)] + kept, own)
            sums = [a + weighted(e, radius) for a, e in zip(alpha, E)]
            may_help = last - first > 2 * LEAST_PIECE and all(a < rho[c] for c, a in zip(own, alpha))
            if may_help and not all(s < rho[c] for c, s in zip(own, sums)):
                pieces += [((first + last) / 2, last), (first, (first + last) / 2)]
                continue
            for c, s in zip(own, sums):
                require(s, rho[c], f"{self.name_of[c]}, |M Phi(x^(t), t)| + |I - M J(x, t)| rho < rho")
                image[c] = max(image[c], s, key=lambda y: y.b)
        error.update(image)
        return {"rho": rho, "rows": rows, "E": E, "alpha": misses(lambda r: abs(total(r.c)))}

    def check_step(self, step):
        (a, b), error, x = (self.poses[step[end]] for end in ("from", "to")), {}, []
        half, span = (iv.mpf(b["t"]) - a["t"]) / 2, (a["t"], b["t"])
        require(ZERO, half, "time goes on")
        for x0, x1, v0, v1 in zip(*map(numbers, (a["x"], b["x"], a["x_dot"], b["x_dot"]))):
            rise, sum_v, bend = x1 - x0, half * (v0 + v1) / 4, half * (v1 - v0) / 4
            x.append(Poly((x0 + x1) / 2 - bend, rise * 3 / 4 - sum_v, bend, sum_v - rise / 4))  # x^ in sigma, and so t
        t = Poly((iv.mpf(a["t"]) + b["t"]) / 2, half)
        parts = [self.check_part(part, x, t, span, error) for part in step["parts"]]
        self.left = max(self.left, sum(len(part.get("kept", [])) for part in step["parts"]))
        if len(error) < self.size or self.left > self.free:
            raise Wrong(f"{len(error)} of {self.size} coordinates are proved, {self.left} combinations left free; {self.free} may be")
        repeated = [row for row in self.all_rows if not any(row in part["rows"] for part in parts)]
        at_end = self.rows(repeated, [Poly(total(f.c)) for f in x], Poly(iv.mpf(b["t"])), (b["t"], b["t"]))
        for (e, _), value in zip(repeated, at_end):
            require(value.bound(), REPEATED_HOLD, f"{self.equations[e]['name']}, which repeats others, holds at the end")
            self.repeated = max(self.repeated, float(value.bound().b))
        return parts

    def check_joint(self, before, after):
        """The solution of a step ends in the tube of the next one, which contains only one. @return whether that proves other rows"""
        rho, next_rho = ({c: r for part in parts for c, r in part["rho"].items()} for parts in (before, after))
        share = min([ONE] + [next_rho[c] / r for c, r in rho.items()], key=lambda y: y.a)
        radius = {c: share * r for c, r in rho.items()}
        for part in before:
            sums = {c: a + weighted(e, radius) for c, a, e in zip(part["rho"], part["alpha"], part["E"])}
            for c, x in sums.items():
                require(x, radius[c], f"{self.name_of[c]}, the solution of the step before is in the tube")
            radius |= sums
        return [sorted(part["rows"]) for part in before] != [sorted(part["rows"]) for part in after]


def check(proof):
    said, before, claimed, changes = [proof.check_rank()] if proof.rank else [], None, [], 0
    for k, step in enumerate(proof.steps):
        try:
            claimed += [step["not_proved"]] if "not_proved" in step else []
            after = None if "not_proved" in step else proof.check_step(step)
            changes += bool(before and after) and proof.check_joint(before, after)
        except Wrong as wrong:
            raise Wrong(f"step {k}, t = {proof.poses[k]['t']} to {proof.poses[k + 1]['t']} s: {wrong}") from None
        before = after
    said.append(f"equations that repeat others hold at the poses up to {proof.repeated:.2g}; other rows are proved from {changes} poses on")
    said += [f"{claimed.count(reason)} steps are claimed only: {reason}" for reason in sorted(set(claimed))]
    if proof.steps and len(claimed) == len(proof.steps):
        raise Wrong("of the motion nothing is proved; " + said[-1])
    free = f"; combinations of coordinates that are left free: {proof.left}" if proof.left else ""
    return said + [f"yes: {len(proof.steps) - len(claimed)} of {len(proof.steps)} steps are proved{free}"]


def main(arguments):
    try:
        with open(*arguments, mode="rb") as file:
            text = file.read()
        data, (before, _, after) = json.loads(text), text.rpartition(b',"sha256":"')
        if (data["format"], data["version"]) != ("jointwise proof", 1) or hashlib.sha256(before).hexdigest() != data["sha256"]:
            raise ValueError("it is no proof of version 1, or was changed: its content has another hash than the one at its end")
        print("\n".join(check(Proof(data))))
    except Wrong as wrong:
        print(f"no: {wrong}")
        return 1
    except (OSError, ValueError, LookupError, TypeError, AttributeError, ArithmeticError, RuntimeError) as fault:
        place = f"{fault.lineno}:{fault.colno}" if isinstance(fault, json.JSONDecodeError) else "1:1"
        print(f"{' '.join(arguments)}:{place}: {type(fault).__name__}: {fault}; expected one file of 'solve --proof'", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__": sys.exit(main(sys.argv[1:]))
