"""What OpenCASCADE's analyser finds wrong with a solid."""


def find_faults(solid):
    """OpenCASCADE's analyser, with self-intersections. A round edge of two quarters is smooth, but its knot is one of
    position alone (C0), which it mentions and which is no fault."""
    try:
        solid.check(True)
    except ValueError as fault:
        return {line for line in str(fault).splitlines()[1:] if line and not line.endswith("GeomAbs_C0")}
    return set()
