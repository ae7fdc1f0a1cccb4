"""Sun and Earth over places of the Moon by JPL's DE421, for the test beside this file.

Standard input: one line a place and date, `ISO-8601-UTC longitude-deg latitude-deg radius-m`.
Standard output: one line each: azimuth, elevation (deg) and distance (m) of the Sun, the same of the Earth, the lit share of the
Earth, and longitude and latitude (deg) of the sub-solar and of the sub-Earth point.

Positions, librations and their rotation into the mean-Earth axes are DE421's; light time and aberration are worked out here.
Nothing is taken from the crate under test.
"""
import sys
from datetime import datetime

import de421
import numpy as np
from jplephem.ephem import Ephemeris

LIGHT = 299792.458  # km/s
DAY = 86400.0
ARCSECOND = np.pi / 180 / 3600
# US Naval Observatory, tai-utc.dat: Julian day of the first day; TAI - UTC = a + (MJD - b) c.
BEFORE_1972 = [
    (2437300.5, 1.4228180, 37300, 0.001296),
    (2437512.5, 1.3728180, 37300, 0.001296),
    (2437665.5, 1.8458580, 37665, 0.0011232),
    (2438334.5, 1.9458580, 37665, 0.0011232),
    (2438395.5, 3.2401300, 38761, 0.001296),
    (2438486.5, 3.3401300, 38761, 0.001296),
    (2438639.5, 3.4401300, 38761, 0.001296),
    (2438761.5, 3.5401300, 38761, 0.001296),
    (2438820.5, 3.6401300, 38761, 0.001296),
    (2438942.5, 3.7401300, 38761, 0.001296),
    (2439004.5, 3.8401300, 38761, 0.001296),
    (2439126.5, 4.3131700, 39126, 0.002592),
    (2439887.5, 4.2131700, 39126, 0.002592),
]
LEAPS = (
    "1972-01 1972-07 1973-01 1974-01 1975-01 1976-01 1977-01 1978-01 1979-01 1980-01 1981-07 1982-07 1983-07 1985-07 1988-01 "
    "1990-01 1991-01 1992-07 1993-07 1994-07 1996-01 1997-07 1999-01 2006-01 2009-01 2012-07 2015-07 2017-01"
).split()


def atomic_ahead(when, julian):
    """TAI - UTC (s)."""
    month = f"{when.year:04}-{when.month:02}"
    leaps = sum(start <= month for start in LEAPS)
    if leaps:
        return 9.0 + leaps
    # In 1960 the formula of 1961 is extended backwards.
    row = [row for row in BEFORE_1972 if row[0] <= julian] or BEFORE_1972[:1]
    _, first, origin, rate = row[-1]
    return first + (julian - 2400000.5 - origin) * rate


def turn(axis, angle):
    """Turns of the axes, one matrix an angle."""
    c, s, o, i = np.cos(angle), np.sin(angle), np.zeros_like(angle), np.ones_like(angle)
    rows = {1: [[i, o, o], [o, c, s], [o, -s, c]], 2: [[c, o, -s], [o, i, o], [s, o, c]], 3: [[c, s, o], [-s, c, o], [o, o, i]]}
    return np.moveaxis(np.array(rows[axis]), -1, 0)


def mean_earth_axes(ephemeris, days, fraction):
    """Matrices from the ICRF to the mean-Earth axes of DE421."""
    phi, theta, psi = ephemeris.position("librations", days, fraction)
    principal = turn(3, psi) @ turn(1, theta) @ turn(3, phi)
    # NAIF, moon_080317.tf.
    angles = [np.full_like(phi, -angle * ARCSECOND) for angle in (0.30, 78.56, 67.92)]
    return turn(1, angles[0]) @ turn(2, angles[1]) @ turn(3, angles[2]) @ principal


def main():
    rows = [line.split() for line in sys.stdin if line.strip()]
    when = [datetime.fromisoformat(row[0].replace("Z", "+00:00")) for row in rows]
    longitude, latitude = (np.radians([float(row[k]) for row in rows]) for k in (1, 2))
    radius = np.array([float(row[3]) for row in rows]) / 1000
    midnight = np.array([float(one.toordinal()) + 1721424.5 for one in when])
    seconds = np.array([one.hour * 3600 + one.minute * 60 + one.second + one.microsecond / 1e6 for one in when])
    ahead = np.array([atomic_ahead(one, day + s / DAY) for one, day, s in zip(when, midnight, seconds)])
    fraction = (seconds + ahead + 32.184) / DAY

    ephemeris = Ephemeris(de421)
    share = 1 / (1 + ephemeris.EMRAT)

    def at(name, before):
        return ephemeris.position(name, midnight, fraction - before / DAY)

    def earth(before):
        return at("earthmoon", before) - at("moon", before) * share

    def moon(before):
        return earth(before) + at("moon", before)

    velocity = (moon(-30.0) - moon(30.0)) / 60
    axes = mean_earth_axes(ephemeris, midnight, fraction)
    cos_b, sin_b, cos_l, sin_l = np.cos(latitude), np.sin(latitude), np.cos(longitude), np.sin(longitude)
    up = np.array([cos_b * cos_l, cos_b * sin_l, sin_b])
    east = np.array([-sin_l, cos_l, np.zeros_like(sin_l)])
    north = np.array([-sin_b * cos_l, -sin_b * sin_l, cos_b])

    def apparent(place, origin):
        """Vector from an origin (ICRF, from the Moon's centre) with light time and aberration, in the axes of the Moon (km)."""
        before = np.zeros_like(radius)
        for _ in range(4):
            away = place(before) - moon(0.0) - origin
            before = np.linalg.norm(away, axis=0) / LIGHT
        distance = np.linalg.norm(away, axis=0)
        seen = away / distance + velocity / LIGHT
        return np.einsum("nij,jn->in", axes, seen / np.linalg.norm(seen, axis=0)) * distance

    site = np.einsum("nji,jn->in", axes, up * radius)
    columns = []
    for body in (lambda before: at("sun", before), earth):
        away = apparent(body, site)
        distance = np.linalg.norm(away, axis=0)
        x, y, z = ((away * axis).sum(axis=0) for axis in (north, east, up))
        columns += [np.degrees(np.arctan2(y, x)) % 360, np.degrees(np.arcsin(z / distance)), distance * 1000]
    to_sun, to_site = at("sun", 0.0) - earth(0.0), moon(0.0) + site - earth(0.0)
    cosine = (to_sun * to_site).sum(axis=0) / np.linalg.norm(to_sun, axis=0) / np.linalg.norm(to_site, axis=0)
    columns.append((1 + cosine) / 2)
    for body in (lambda before: at("sun", before), earth):
        x, y, z = apparent(body, np.zeros_like(site))
        columns += [np.degrees(np.arctan2(y, x)), np.degrees(np.arctan2(z, np.hypot(x, y)))]
    np.savetxt(sys.stdout, np.array(columns).T, fmt="%.9f")


main()
