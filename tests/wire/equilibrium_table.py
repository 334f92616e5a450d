#!/usr/bin/env python3
"""Reference shapes for test_equilibrium.c: chains in space under random forces, by scipy.

/usr/bin/python3 equilibrium_table.py > equilibrium_table.h

Another way than the library's: the potential energy is minimised over the positions of the nodes under the lengths of
the edges (SLSQP), then positions and edge tensions are polished together as roots of the balance of every node and the
length of every edge (MINPACK hybrd). The seed is fixed."""
import numpy as np
from scipy import optimize

N = 13
SLACK = [1.5, 1.125, 1.02, 1.0005]


def edges(x):
    return np.diff(x, axis=0)


def solve(end, force, length):
    """Nodes and edge tensions of the chain from the origin to `end`."""
    n = len(force)

    def nodes(free):
        return np.vstack([[0, 0, 0], free.reshape(-1, 3), end])

    def balance(unknown):
        x, tension = nodes(unknown[: 3 * (n - 2)]), unknown[3 * (n - 2):]
        pull = (tension / length)[:, None] * edges(x)
        left = pull[1:] - pull[:-1] + force[1:-1]
        stretch = (edges(x) ** 2).sum(1) / length**2 - 1
        return np.concatenate([left.ravel(), 10 * stretch])

    t = np.linspace(0, 1, n)[1:-1, None]
    total = force[1:-1].sum(0)
    sag = 0.6 * np.sqrt(length.sum() ** 2 - end @ end) * 4 * t * (1 - t) * total / np.linalg.norm(total)
    found = optimize.minimize(
        lambda free: -(force[1:-1] * free.reshape(-1, 3)).sum(), (t * end + sag).ravel(), method="SLSQP",
        jac=lambda free: -force[1:-1].ravel(),
        constraints={"type": "eq", "fun": lambda free: (edges(nodes(free)) ** 2).sum(1) / length**2 - 1},
        options={"maxiter": 2000, "ftol": 1e-15})
    x = nodes(found.x)
    unit = edges(x) / np.linalg.norm(edges(x), axis=1)[:, None]
    # tensions that balance the nodes best: linear least squares
    rows = np.zeros((3 * (n - 2), n - 1))
    for i in range(1, n - 1):
        rows[3 * i - 3: 3 * i, i] = unit[i]
        rows[3 * i - 3: 3 * i, i - 1] = -unit[i - 1]
    tension = np.linalg.lstsq(rows, -force[1:-1].ravel(), rcond=None)[0]
    root = optimize.root(balance, np.concatenate([x[1:-1].ravel(), tension]), method="hybr",
                         options={"xtol": 1e-14, "maxfev": 200000})
    x, tension = nodes(root.x[: 3 * (n - 2)]), root.x[3 * (n - 2):]
    assert np.abs(balance(root.x)).max() < 1e-10 * max(1, tension.max()), np.abs(balance(root.x)).max()
    assert tension.min() > 0
    return x, tension


def main():
    random = np.random.default_rng(20160901)
    print("/* Written by equilibrium_table.py (scipy): chains in space and their shapes. */")
    print("/* clang-format off */")
    print(f"enum {{ TABLE_NODES = {N}, TABLE_CHAINS = {len(SLACK)} }};")
    print("static const struct {\n    double end[3], length[TABLE_NODES - 1], force[TABLE_NODES][3], "
          "x[TABLE_NODES][3], tension[TABLE_NODES - 1];\n} table[TABLE_CHAINS] = {")
    for slack in SLACK:
        end = np.array([400.0, *np.round(random.uniform(-60, 60, 2), 1)])
        share = random.uniform(0.5, 1.5, N - 1)
        length = np.round(share / share.sum() * slack * np.linalg.norm(end), 6)
        force = np.round(random.normal(0, 0.02, (N, 3)) + [0.02, 0.12, -0.08], 4)
        x, tension = solve(end, force, length)
        flat = lambda a: ", ".join(repr(float(v)) for v in np.ravel(a))
        nested = lambda a: ",\n      ".join("{" + flat(row) + "}" for row in a)
        print(f"    {{ /* length over chord {slack} */\n     {{{flat(end)}}},\n     {{{flat(length)}}},\n"
              f"     {{{nested(force)}}},\n     {{{nested(x)}}},\n     {{{flat(tension)}}}}},")
    print("};")


if __name__ == "__main__":
    main()
