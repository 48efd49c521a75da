"""Numbers of check_proof.py: polynomials with intervals as coefficients, intervals with derivatives, and functions of both.
Knows Debian's python3-mpmath and nothing else."""
from itertools import product, zip_longest
from math import comb
from mpmath import iv, mp

iv.prec, mp.prec, DEGREE = 80, 80, 12  # bits; degree of polynomials in time: n1, a product of two vectors that turn, has this one
ZERO, ONE, AROUND = iv.mpf(0), iv.mpf(1), iv.mpf([-1, 1])

total = lambda numbers: sum(numbers, ZERO)
Wrong = type("Wrong", (Exception,), {"__doc__": "What does not hold."})



class Poly:
    """Polynomial in sigma, -1 <= sigma <= 1, whose coefficients are intervals; powers above DEGREE are enclosed in the last."""

    def __init__(self, *c):
        self.c = c

    __add__ = lambda self, other: Poly(*(x + y for x, y in zip_longest(self.c, other.c, fillvalue=ZERO)))
    times = lambda self, number: Poly(*(x * number for x in self.c))
    bound = lambda self: total(map(abs, self.c))

    def __mul__(self, other):
        c = [ZERO] * min(len(self.c) + len(other.c) - 1, DEGREE + 1)
        for (k, x), (l, y) in product(enumerate(self.c), enumerate(other.c)):
            c[min(k + l, DEGREE)] += x * y if k + l <= DEGREE else x * y * AROUND
        return Poly(*c)

    def range_over(self, middle, half):
        """Encloses the values from middle - half to middle + half."""
        about = [total(x * comb(k, n) * middle ** (k - n) for k, x in enumerate(self.c) if k >= n) for n in range(len(self.c))]
        return about[0] + AROUND * total(abs(x) * half**n for n, x in enumerate(about) if n > 0)

    def sine_and_cosine(self):
        """Taylor's series about the middle, with its remainder."""
        change, power, size = Poly(ZERO, *self.c[1:]), Poly(ONE), ONE
        sine, cosine = Poly(iv.sin(self.c[0])), Poly(iv.cos(self.c[0]))
        derivatives = [sine, cosine, sine.times(-ONE), cosine.times(-ONE)]
        for n in range(1, 25):
            power, size = (power * change).times(ONE / n), size * change.bound() / n
            sine, cosine = sine + power * derivatives[n % 4], cosine + power * derivatives[(n + 1) % 4]
        rest = Poly(AROUND * size * iv.exp(change.bound()))
        return sine + rest, cosine + rest


class Grad:
    """Interval with its derivatives by columns."""

    def __init__(self, value, d={}):
        self.value, self.d = value, d

    def combined(self, value, f, other, g):
        d = {k: x * f for k, x in self.d.items()}
        for k, x in other.d.items():
            d[k] = d.get(k, ZERO) + x * g
        return Grad(value, d)

    __add__ = lambda self, other: self.combined(self.value + other.value, ONE, other, ONE)
    __mul__ = lambda self, other: self.combined(self.value * other.value, other.value, other, self.value)
    times = lambda self, number: Grad(self.value * number, {k: x * number for k, x in self.d.items()})

    def sine_and_cosine(self):
        sine, cosine = iv.sin(self.value), iv.cos(self.value)
        return Grad(sine, self.times(cosine).d), Grad(cosine, self.times(-sine).d)


Poly.__sub__ = Grad.__sub__ = lambda x, y: x + y.times(-ONE)


def series(poly, coefficient, size):
    """Sum of coefficient(n) poly^n from n = 0 on, where |coefficient(n)| <= 1; size < 1 bounds the polynomial."""
    if not size.b < 1:
        raise Wrong("a formula changes too much over the step")
    value, power, terms = Poly(ZERO), Poly(ONE), 40 if len(poly.c) > 1 else 1  # of a constant, which is 0, the first
    for n in range(terms):
        value, power = value + power.times(coefficient(n)), power * poly
    return value + Poly(AROUND * size**terms / (ONE - size))


def change_of(p):
    """p = c (1 + d): d, where c is not zero."""
    if 0 in p.c[0]:
        raise Wrong("a formula has no value")
    return Poly(ZERO, *p.c[1:]).times(ONE / p.c[0])


def reciprocal(p):
    d = change_of(p)
    return series(d, lambda n: ONE * (-1) ** n, d.bound()).times(ONE / p.c[0])


def logarithm(p):
    d = change_of(p)
    if p.c[0] < 0:
        raise Wrong("a formula has no value")
    return Poly(iv.log(p.c[0])) + series(d, lambda n: ZERO if n == 0 else -ONE * (-1) ** n / n, d.bound())


def exponential(p):
    d = Poly(ZERO, *p.c[1:])
    factorial = lambda n: ONE if n < 2 else factorial(n - 1) * n
    return series(d, lambda n: ONE / factorial(n), d.bound()).times(iv.exp(p.c[0]))


def arc_tangent(p):
    """atan(c + d) = atan c + atan(d / (1 + c (c + d)))."""
    c, d = p.c[0], Poly(ZERO, *p.c[1:])
    u = d * reciprocal(Poly(ONE) + p.times(c))
    odd = lambda n: ONE * (-1) ** (n // 2) / n if n % 2 else ZERO
    ends = [mp.atan(mp.mpf(x)) for x in (c.a, c.b)]  # increasing; correct to a few of 80 bits
    return Poly(iv.mpf([ends[0] - mp.mpf(2) ** -70, ends[1] + mp.mpf(2) ** -70])) + series(u, odd, u.bound())


def power(p, n):
    if n == int(n):
        value = Poly(ONE)
        for _ in range(abs(int(n))):
            value = value * p
        return value if n >= 0 else reciprocal(value)
    return exponential(logarithm(p).times(iv.mpf(n)))


def arc_sine(p):
    return arc_tangent(p * power(Poly(ONE) - p * p, -0.5))


def absolute(p):
    d = change_of(p)
    if not d.bound().b < 1:
        raise Wrong("a formula may change its sign over the step")
    return p if p.c[0] > 0 else p.times(-ONE)


OF_ONE = {
    "negative": lambda p: p.times(-ONE),
    "sin": lambda p: p.sine_and_cosine()[0],
    "cos": lambda p: p.sine_and_cosine()[1],
    "tan": lambda p: p.sine_and_cosine()[0] * reciprocal(p.sine_and_cosine()[1]),
    "arcsin": arc_sine,
    "arccos": lambda p: Poly(iv.pi / 2) - arc_sine(p),
    "arctan": arc_tangent,
    "exp": exponential,
    "ln": logarithm,
    "sqrt": lambda p: power(p, 0.5),
    "abs": lambda p: absolute(p),
}
SLOPE_OF = {
    "negative": lambda p: Poly(-ONE),
    "sin": OF_ONE["cos"],
    "cos": lambda p: OF_ONE["sin"](p).times(-ONE),
    "tan": lambda p: power(OF_ONE["cos"](p), -2),
    "arcsin": lambda p: power(Poly(ONE) - p * p, -0.5),
    "arccos": lambda p: power(Poly(ONE) - p * p, -0.5).times(-ONE),
    "arctan": lambda p: reciprocal(Poly(ONE) + p * p),
    "exp": exponential,
    "ln": reciprocal,
    "sqrt": lambda p: power(p, -0.5).times(ONE / 2),
    "abs": lambda p: Poly(ONE if p.c[0] > 0 else -ONE),  # 0 has no value before
}
OF_TWO = {
    "+": lambda p, q: p + q,
    "-": lambda p, q: p - q,
    "*": lambda p, q: p * q,
    "/": lambda p, q: p * applied(["power", -1], q),
}


def applied(step, x):
    """A function of one operand; of a Grad its value for the interval, and the chain rule."""
    if isinstance(step, list):
        n = step[1]  # n - 1 is exact for whole numbers only
        f, one_less = lambda p: power(p, n), lambda p: power(p, n - 1) if n == int(n) else power(p, n) * reciprocal(p)
        slope = lambda p: one_less(p).times(iv.mpf(n))
    else:
        f, slope = OF_ONE[step], SLOPE_OF[step]
    if isinstance(x, Poly):
        return f(x)
    p = Poly(x.value)  # a constant, and so are f and the slope of it
    return Grad(f(p).c[0], x.times(slope(p).c[0]).d)


def evaluated(steps, variables, const):
    """The steps of a formula are for a stack, which the last one leaves with its value."""
    stack = []
    for step in steps:
        if isinstance(step, list) or step in OF_ONE:
            stack.append(applied(step, stack.pop()))
        elif step in OF_TWO:
            q = stack.pop()
            stack.append(OF_TWO[step](stack.pop(), q))
        else:
            stack.append(variables[step] if isinstance(step, str) else const(iv.mpf(step)))
    return stack.pop()
