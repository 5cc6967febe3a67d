# SPDX-License-Identifier: Apache-2.0
"""Expressions over whole numbers.

A node is a mathematical integer with the interval of its possible values, not a bit vector: wrapping is an operation of
its own (`wrap`), and disappears where the interval proves that nothing can wrap. Nodes are built by the functions below,
which simplify locally and give the same object for the same expression; so structural equality is identity. They stand in
one file because each simplifies with the help of the others.
"""


class Node:
    __slots__ = ("op", "args", "param", "low", "high", "ones")

    def __init__(self, op, args, param, low, high, ones):
        self.op, self.args, self.param = op, args, param
        self.low, self.high = low, high  # least and greatest value
        self.ones = ones  # bits that can be 1, for values that are never negative

    @property
    def is_bit(self):
        return self.low >= 0 and self.high <= 1

    @property
    def width(self):
        """Bits of the value, including the sign bit where it can be negative."""
        if self.low >= 0:
            return max(self.high.bit_length(), 1)
        return max(self.high.bit_length(), (-self.low - 1).bit_length()) + 1

    def __repr__(self):
        inner = ", ".join([repr(a) for a in self.args] + ([str(self.param)] if self.param is not None else []))
        return f"{self.op}({inner})"


_interned = {}


def _node(op, args, param, low, high, ones=None):
    key = (op, tuple(id(a) for a in args), param, low, high)
    found = _interned.get(key)
    if found is None:
        if ones is None:
            ones = (1 << high.bit_length()) - 1 if low >= 0 else None
        found = _interned[key] = Node(op, tuple(args), param, low, high, ones)
    return found


def const(value):
    return _node("const", (), value, value, value, value if value >= 0 else None)


def leaf(op, name, width, signed=False):
    """An input, a register's current value or a memory's read data."""
    low, high = (-(1 << (width - 1)), (1 << (width - 1)) - 1) if signed else (0, (1 << width) - 1)
    return _node(op, (), name, low, high)


def is_const(node, value=None):
    return node.op == "const" and (value is None or node.param == value)


def wrap(a, width, signed=False):
    """The value that remains in `width` bits."""
    low, high = (-(1 << (width - 1)), (1 << (width - 1)) - 1) if signed else (0, (1 << width) - 1)
    if low <= a.low and a.high <= high:
        return a
    if a.op == "wrap" and a.param[0] >= width:
        return wrap(a.args[0], width, signed)
    if is_const(a):
        value = a.param & ((1 << width) - 1)
        return const(value - (1 << width) if signed and value >> (width - 1) else value)
    if a.low == -1 and a.high == 0 and not signed:
        return mux(less(a, const(0)), const((1 << width) - 1), const(0))
    if a.op in ("and", "or", "xor") and a.param is not None and not signed:
        return bitwise(a.op, wrap(a.args[0], width), wrap(a.args[1], width))
    if a.op == "mux":
        return mux(a.args[0], wrap(a.args[1], width, signed), wrap(a.args[2], width, signed))
    if a.op == "shl" and not signed:
        return shift_left(wrap(a.args[0], width - a.param), a.param) if a.param < width else const(0)
    if a.op in ("add", "sub", "mul"):
        terms = [_of_width(term, width) for term in a.args]
        if any(new is not old for new, old in zip(terms, a.args)):
            return wrap({"add": add, "sub": sub, "mul": mul}[a.op](*terms), width, signed)
    if a.op == "add" and not signed and disjoint_ones(a.args) is not None:
        return add(*[wrap(term, width) for term in a.args])
    if a.op == "add" and not signed:
        kept = [term for term in a.args if not _multiple_of(term, width)]
        if len(kept) < len(a.args):
            return wrap(add(*kept), width)
    ones = a.ones & high if not signed and a.ones is not None else None
    if ones is not None:
        high = min(high, ones)
    return _node("wrap", (a,), (width, signed), low, high, ones)


LONG = 1 << 31  # no integer of VHDL


def _of_width(node, width):
    """A term of a sum or product of which only the lowest `width` bits count: without a wrapping to more bits, and not longer
    than an integer where that can be avoided."""
    inner = node.args[0] if node.op == "wrap" and node.param[0] >= width else node
    if -LONG <= inner.low and inner.high < LONG:
        return inner
    return wrap(inner, width) if LONG > 1 << width else node


def fits_signed(a, width):
    return -(1 << (width - 1)) <= a.low and a.high < 1 << (width - 1)


def _multiple_of(node, width):
    return node.op == "shl" and node.param >= width


def add(*terms):
    flat, constant = [], 0
    for term in terms:
        for t in term.args if term.op == "add" else (term,):
            if is_const(t):
                constant += t.param
            else:
                flat.append(t)
    if constant or not flat:
        flat.append(const(constant))
    if len(flat) == 1:
        return flat[0]
    low, high = sum(t.low for t in flat), sum(t.high for t in flat)
    return _node("add", flat, None, low, high, disjoint_ones(flat))


def disjoint_ones(terms):
    """The union of the bits of terms that never have a one in the same place, else None."""
    union = 0
    for t in terms:
        if t.ones is None or union & t.ones:
            return None
        union |= t.ones
    return union


def sub(a, b):
    if is_const(b):
        return add(a, const(-b.param))
    if a is b:
        return const(0)
    if b.op == "sub" and is_const(a, 0):
        return sub(b.args[1], b.args[0])
    if a.op == "shl" and a.args[0] is b:
        return mul(b, const((1 << a.param) - 1))
    magnitude = _as_absolute(a, b)
    return magnitude or _node("sub", (a, b), None, a.low - b.high, a.high - b.low)


def _as_absolute(a, b):
    """(d xor s) - s with s the sign of d, as -1 or 0, is |d|."""
    if b.low == -1 and b.high == 0 and a.op == "xor" and b in a.args:
        d = a.args[0] if a.args[1] is b else a.args[1]
        if is_sign_of(b, d):
            return absolute(d)
    return None


def is_sign_of(sign, d):
    return sign.op == "shr" and sign.args[0] is d and (1 << sign.param) > max(d.high, -d.low - 1)


def absolute(a):
    if is_const(a):
        return const(abs(a.param))
    if a.low >= 0:
        return a
    return _node("abs", (a,), None, 0 if a.high >= 0 else -a.high, max(-a.low, a.high))


def folded(a):
    """a, or its complement -1-a where it is negative."""
    if is_const(a):
        return const(a.param if a.param >= 0 else -1 - a.param)
    if a.low >= 0:
        return a
    return _node("folded", (a,), None, 0, max(a.high, -a.low - 1))


def positive(a):
    """a, or 0 where it is negative."""
    if a.low >= 0:
        return a
    return const(0) if a.high <= 0 else _node("positive", (a,), None, 0, a.high)


def mul(a, b):
    if is_const(a):
        a, b = b, a
    if is_const(a):
        return const(a.param * b.param)
    if is_const(b):
        if b.param == 0:
            return b
        if b.param > 0 and b.param & (b.param - 1) == 0:
            return shift_left(a, b.param.bit_length() - 1)
    ends = [x * y for x in (a.low, a.high) for y in (b.low, b.high)]
    return _node("mul", (a, b), None, 0 if a is b and min(ends) < 0 else min(ends), max(ends))


def shift_left(a, count):
    if count == 0 or is_const(a, 0):
        return a
    if is_const(a):
        return const(a.param << count)
    if a.op == "shl":
        return shift_left(a.args[0], a.param + count)
    return _node("shl", (a,), count, a.low << count, a.high << count, None if a.ones is None else a.ones << count)


def shift_right(a, count):
    """Division by 2**count, rounded down."""
    if count == 0:
        return a
    if is_const(a):
        return const(a.param >> count)
    if a.low >= 0 and a.high >> count == 0:
        return const(0)
    if a.op == "shr":
        return shift_right(a.args[0], a.param + count)
    if a.op == "wrap" and a.param == (count + 1, False) and fits_signed(a.args[0], count + 1):
        return less(a.args[0], const(0))
    if a.op == "wrap" and a.high >= LONG and not a.param[1]:
        return wrap(shift_right(a.args[0], count), a.param[0] - count)
    if a.op == "shl" and a.param >= count:
        return shift_left(a.args[0], a.param - count)
    if a.op == "add" and disjoint_ones(a.args) is not None:
        return add(*[shift_right(t, count) for t in a.args])
    return _node("shr", (a,), count, a.low >> count, a.high >> count, None if a.ones is None else a.ones >> count)


def mux(condition, yes, no):
    if is_const(condition):
        return yes if condition.param else no
    if yes is no:
        return yes
    if condition.op == "not":
        return mux(condition.args[0], no, yes)
    if yes.op == "mux" and yes.args[0] is condition:
        yes = yes.args[1]
    if no.op == "mux" and no.args[0] is condition:
        no = no.args[2]
    if yes.is_bit and no.is_bit:
        held = _held_bit(yes, no)
        if held is not None:
            return mux(held[0], condition, held[1])
        if is_const(yes, 1):
            return bit_or(condition, no)
        if is_const(no, 0):
            return bit_and(condition, yes)
        if is_const(yes, 0):
            return bit_and(bit_not(condition), no)
        if is_const(no, 1):
            return bit_or(bit_not(condition), yes)
    if condition.op == "lt" and is_const(condition.args[1], 0):
        a = condition.args[0]
        if no.op == "wrap" and no.args[0] is a and a.high >> no.param[0] == 0:
            no = positive(a)
        if no is positive(a) and yes.op == "sub" and _is_complement(yes, a):
            return folded(a)
    ones = None if yes.ones is None or no.ones is None else yes.ones | no.ones
    return _node("mux", (condition, yes, no), None, min(yes.low, no.low), max(yes.high, no.high), ones)


def _is_complement(node, a):
    """2**w - 1 - (a modulo 2**w), which is -1-a for the negative values that w bits hold."""
    top, low_bits = node.args
    return (
        is_const(top)
        and low_bits.op == "wrap"
        and low_bits.args[0] is a
        and not low_bits.param[1]
        and top.param == (1 << low_bits.param[0]) - 1
        and a.low >= -(1 << low_bits.param[0])
    )


def _held_bit(yes, no):
    """(take, a) where a choice of `a or take` or `a and not take` gives its condition when `take`, else a."""
    if (
        yes.op == "or"
        and no.op == "and"
        and len(yes.args) == len(no.args) == 2
        and yes.param is None
        and no.param is None
    ):
        for a, take in (yes.args, yes.args[::-1]):
            if a in no.args and bit_not(take) in no.args:
                return take, a
    return None


def bit_not(a):
    opposite = {"lt": "ge", "ge": "lt", "eq": "ne", "ne": "eq"}
    if is_const(a):
        return const(1 - a.param)
    if a.op == "not":
        return a.args[0]
    if a.op in opposite:
        return _node(opposite[a.op], a.args, None, 0, 1)
    return _node("not", (a,), None, 0, 1)


def bit_and(*args):
    node = _associative("and", args, neutral=1)
    return _joined_bits(node) if node.op == "and" else node


def _tested_field(node):
    """(word, lowest bit, bits, wanted value) where the node tests some neighbouring bits of a word, else None."""
    if node.op == "eq" and is_const(node.args[1]):
        part, wanted = node.args[0], node.args[1].param
    else:
        part, wanted = (node.args[0], 0) if node.op == "not" else (node, 1)
        if not part.is_bit:
            return None
    width = part.width
    if part.low < 0 or part.op not in ("wrap", "shr") or (part.op == "wrap" and part.param[1]):
        return None
    word = part.args[0] if part.op == "wrap" else part
    return (word.args[0], word.param, width, wanted) if word.op == "shr" else (word, 0, width, wanted)


def _joined_bits(node):
    """Tests of neighbouring bits of one word become one comparison: the tool splits comparisons with constants into bits."""
    words, others = {}, []
    for a in node.args:
        tested = _tested_field(a)
        if tested is None:
            others.append(a)
        else:
            words.setdefault(id(tested[0]), []).append((tested, a))
    joined = False
    for tests in words.values():
        tests.sort(key=lambda test: test[0][1])
        word, low = tests[0][0][:2]
        ends = [test[1] + test[2] for test, _ in tests]
        width = ends[-1] - low
        if len(tests) > 1 and all(end == test[1] for end, (test, _) in zip(ends, tests[1:])):
            wanted = sum(value << (bit - low) for (_, bit, _, value), _ in tests)
            others.append(equal(wrap(shift_right(word, low), width), const(wanted)))
            joined = True
        else:
            others += [a for _, a in tests]
    return _associative("and", others, neutral=1) if joined else node


def bit_or(*args):
    return _associative("or", args, neutral=0)


def _associative(op, args, neutral):
    flat = []
    for a in args:
        for b in a.args if a.op == op else (a,):
            if is_const(b, 1 - neutral):
                return b
            if not is_const(b) and b not in flat:
                flat.append(b)
    if not flat:
        return const(neutral)
    return flat[0] if len(flat) == 1 else _node(op, flat, None, 0, 1)


def bit_xor(a, b):
    if is_const(a):
        a, b = b, a
    if is_const(b):
        return bit_not(a) if b.param else a
    return const(0) if a is b else _node("ne", (a, b), None, 0, 1)


def less(a, b):
    if a.op == "shr" and is_const(b, 0):
        return less(a.args[0], b)
    if a.high < b.low:
        return const(1)
    if a.low >= b.high:
        return const(0)
    if _wraps_negatives_beyond(a, b):  # 0 <= x < b
        return bit_and(bit_not(less(a.args[0], const(0))), less(a.args[0], b))
    if _wraps_negatives_beyond(b, a):  # x < 0 or a < x
        return bit_or(less(b.args[0], const(0)), less(a, b.args[0]))
    return _node("lt", (a, b), None, 0, 1)


def _wraps_negatives_beyond(node, other):
    """An unsigned comparison whose negative numbers count as more than any value of `other`: a range check."""
    if node.op != "wrap" or node.param[1] or node.args[0].low >= 0 or other.low < 0:
        return False
    inner, modulus = node.args[0], 1 << node.param[0]
    return inner.high < modulus and inner.low + modulus > other.high


def equal(a, b):
    if a is b:
        return const(1)
    if a.high < b.low or b.high < a.low:
        return const(0)
    if is_const(a):
        a, b = b, a
    if a.is_bit and is_const(b):
        return a if b.param else bit_not(a)
    return _node("eq", (a, b), None, 0, 1)


def bitwise(op, a, b):
    """and, or, xor of whole numbers in two's complement."""
    if a.is_bit and b.is_bit:
        return {"and": bit_and, "or": bit_or, "xor": bit_xor}[op](a, b)
    if is_const(a):
        a, b = b, a
    if is_const(a) and is_const(b):
        return const({"and": int.__and__, "or": int.__or__, "xor": int.__xor__}[op](a.param, b.param))
    if op == "and" and is_const(b) and b.param >= 0:
        return _masked(a, b.param)
    if op in ("or", "xor"):
        if is_const(b, 0):
            return a
        if disjoint_ones((a, b)) is not None:
            return add(a, b)
    if op == "xor":
        for choice, other in ((a, b), (b, a)):
            if choice.op == "mux" and is_const(choice.args[1]) and is_const(choice.args[2]):
                return mux(choice.args[0], *[bitwise("xor", other, arm) for arm in choice.args[1:]])
        if is_const(b) and a.ones is not None and b.param & (b.param + 1) == 0 and a.ones <= b.param:
            return sub(b, a)
    if a.low >= 0 and b.low >= 0:
        bits = max(a.width, b.width)
        return _node(op, (a, b), bits, 0, (1 << bits) - 1)
    bits = max(a.width, b.width) + 1
    return _node(op, (a, b), bits, -(1 << (bits - 1)), (1 << (bits - 1)) - 1)


def _masked(a, mask):
    """The bits of `a` under a mask, as a sum of its runs of ones."""
    runs, at = [], 0
    while mask >> at:
        if not mask >> at & 1:
            at += 1
            continue
        length = ((mask >> at) + 1 & -((mask >> at) + 1)).bit_length() - 1
        runs.append(shift_left(wrap(shift_right(a, at), length), at))
        at += length
    return add(*runs)


def walk(roots):
    """Each node once, arguments before users."""
    seen, order = set(), []
    for root in roots:
        stack = [(root, False)]
        while stack:
            node, ready = stack.pop()
            if ready:
                order.append(node)
            elif id(node) not in seen:
                seen.add(id(node))
                stack.append((node, True))
                stack.extend((argument, False) for argument in reversed(node.args))
    return order


def rebuild(node, replacement, done):
    """The same expression with some leaves replaced (id of the leaf -> node), simplified again. `done` caches results."""
    for n in walk([node]):
        if id(n) in done:
            continue
        if id(n) in replacement:
            done[id(n)] = replacement[id(n)]
        else:
            done[id(n)] = _again(n, [done[id(a)] for a in n.args])
    return done[id(node)]


def _again(node, args):
    make = {
        "wrap": lambda a: wrap(a, *node.param),
        "add": add,
        "sub": sub,
        "mul": mul,
        "abs": absolute,
        "folded": folded,
        "positive": positive,
        "mux": mux,
        "lt": less,
        "eq": equal,
        "shl": lambda a: shift_left(a, node.param),
        "shr": lambda a: shift_right(a, node.param),
        "not": bit_not,
        "ge": lambda a, b: bit_not(less(a, b)),
        "ne": lambda a, b: bit_not(equal(a, b)),
    }
    if not args:
        return node
    if node.op in make:
        return make[node.op](*args)
    if node.param is None:
        return {"and": bit_and, "or": bit_or}[node.op](*args)
    return bitwise(node.op, *args)
