//! `exact`: the same picture by closed form and root finding in f64, independent of ramps, registers, sweeps and
//! sampling. The error of a machine is its difference from this; the planes of truth are its own.
//!
//! ```text
//!  levels, craters ---> Ceilings (once a stage) ----------------+
//!                                                               v
//!  x, y of the screen --> yoke --> View (law) --> Ray ------> Ground --> first meeting --> slopes, craters
//!                            |                                  ^                               |
//!                            |      place on the map --> line to the sun <----------- photometry, texture
//!                            |                                  |                               |
//!                            v                                  v                               v
//!  bodies --> perspective --> first face -----> depth ------> shadow ----------------------> Seen --> planes
//!                                                 |                                                      ^
//!  face lists --> perspective --> triangles, areas -> near to far, before ground and bodies ---> Mean ----+
//!  effects --> perspective --> outlines, areas -> stack of a pixel, near to far -----------> Mix --------+
//! ```
//!
//! # Law
//!
//! - **Pixels.** View-plane at distance 1. The centre of column i lies at `x = tan_half_width (2i + 1 - columns) /
//!   columns`; line j covers y, positive down, from `tan_half_height (2j / lines - 1)` to the same of `j + 1`.
//! - **Yoke** at angle a: the screen's (x, y) shows `(x cos a - y sin a, x sin a + y cos a)` of the view-plane, what a
//!   camera rolled by a has there.
//! - **Rays** (15.3, inverted), theta the pitch:
//!   `Exact`: forward `cos theta + y sin theta`, starboard `x`, down `y cos theta - sin theta`;
//!   `AsReported`: azimuth `heading + atan x`, elevation `theta - atan y`;
//!   `Corrected`: the same azimuth, `tan eta = -y cos(atan x)`.
//! - **Ground.** At range s along the azimuth: h of the finest level and of all craters (9), less the drop of the lunoid
//!   (15.4): `s^2 / 2R`, or `R - sqrt(R^2 - s^2)` up to s = R, where the sphere ends. The ray with `t = tan eta` meets it at
//!   the first root of `G(s) = h(s) - drop(s) - H - t s` from the near range to the far range or the edge of the level: the
//!   highest elevation so far, that is the ideal form of both occultation laws (15.2).
//! - **Near range.** The machine's first sample where sweeps could draw the pose: an eye over the finest level, and |pitch| +
//!   half the vertical field of view, yoke included, below 80 degrees. Else 0: ground is seen from under the eye on.
//! - **Two levels** (8), if the settings have a switch: the finest level up to the range of the switch or its own edge,
//!   then the next level; also before the fine level begins. Over the last `blend` metres before the switch `h = w fine + (1 - w) coarse`, `w = g00`;
//!   slopes are those of that sum along the line of sight.
//! - **Light** (7). `albedo n.s` times the photometric factor, from the slopes of terrain and craters; under
//!   `FeatureLight::AsReported` from those of craters alone inside any footprint. The map is flat for light: sight rises
//!   by `(h - H) / s`, without curvature.
//! - **Remote shadow** (11.1), if the settings have it: a place of the map is dark if the straight line from it to the
//!   sun meets the ground (over all levels, of each place the finest), a body or a part of the vehicle, or if it lies in a track patch. Its
//!   own steepness counts: ground in local shadow is dark. The line begins `LIFT` above the ground.
//! - **Texture** (13) is added behind the shadow: to `max(r, 0)` or to black under `TextureInShadow::On`; under `Off` to
//!   the signed r, nothing in remote shadow. On ground of a colour a channel gets its albedo over the luminance of all three as a
//!   share of it: the grain keeps the colour of its ground, and its luminance. The sum is held to 0..=1.
//! - **Bodies** (12) stand in true perspective under every projection law, lowered by the drop of the lunoid at their
//!   foot point. `Depth`: the nearest of ground and faces, by ground range. `AsReported`: a body is drawn whole, over
//!   everything, the nearer foot on top, unless ground before its foot point stands higher than it by more than
//!   `FOOT_TOLERANCE`. A face returns `albedo max(n.s, 0)`; if terrain and craters shadow the foot point the body is
//!   black or not there. A face has an albedo for each colour.
//! - **Guests.** An object that moves stands where its frame is at the time of the pose, and casts from there. A face of an
//!   open surface is seen, lit and casts by the side that is met. Normals at corners are mixed over the triangles of a face,
//!   and light follows them; outlines and cast shadow follow the faces. A group with a sun of its own has its light from there:
//!   no ground darkens it, and it casts nothing. Where two bodies, or a body and the ground, coincide within `COINCIDENCE`, the
//!   higher priority is seen; the ground's is 0.
//! - **Silhouettes** (8): a ray that meets nothing shows the first listed that stands above it; where sweeps could not draw
//!   the pose they stand on the horizon, and a ray below it shows nothing.
//! - **Pixel rule.** `Centre`: one ray. `LineMean`: the mean over the line's height at the column's centre, by
//!   adaptive quadrature to [`LINE_MEAN_TOLERANCE`].
//!
//! # Lists of faces
//!
//! Sea, wakes, ships and effects of faces lie over ground and bodies. A scene without them costs nothing, and its picture is the
//! same to the bit.
//!
//! - **Place.** True perspective under every projection law. Each corner stands lower by the drop of the lunoid at its own place.
//! - **Depth.** The nearest face is seen, whatever the priority of its list. Faces whose nearness differs by less than
//!   `COINCIDENCE` coincide: the list of the lower number is seen, in it the face stored first. A face hides ground and bodies that
//!   coincide with it. Between its corners the curved ground may stand above it by the sag of the lunoid.
//! - **Hull.** A ship has its whole hull, cut at the height of the water, whatever a scenario does to hide the hull. Boxes and wedges
//!   are not drawn.
//! - **Light.** Corners have the brightness of `faces` under the list's own sun. Faces of more than three corners are cut in
//!   triangles from their first corner. Brightness is linear over a triangle in space.
//! - **Levels** are laid upon what lies behind them: `a + b` without a clamp, `1 - (1 - a)(1 - b)`, or in its place. The label stays
//!   that of what lies behind, unless the level replaces it.
//! - **Area.** In a pixel each face has the area that is seen of it, in closed form (`face_areas`). Where ground or a body passes
//!   between the faces of a pixel, [`SUB_RAYS`] sub-rays say what is seen.
//! - Faces throw no shadow and receive none. The normal of a sea in the planes is that of its face, not the false one.
//!
//! # Sea of waves
//!
//! - A sea of `wind-waves` takes the place of the flat sea and of levels upon it. It stands in true perspective, lowered by the drop of
//!   the lunoid, within its area. A ray meets the first water: the water's bend bounds every step, so no crest is stepped over.
//! - Light is `colour max(0, n.s)` under the scene's sun. A pixel that shows water, or whose neighbour above or below does, has the mean
//!   over its area, whatever the pixel rule: five rays where they agree, else [`SUB_RAYS`].
//! - Ground at or below the calm water hides none. Hulls are whole: the water hides them. Waves throw no shadow.
//!
//! # Effects
//!
//! Light points, sheets, overlays and discs of the sky lie over the opaque picture, lists of faces included, which is drawn as if they were not there. A
//! scene without them costs nothing, and its picture is the same to the bit.
//!
//! - **Stack.** From near to far, with translucency tau and colour c: `sum (1 - tau_i) T_i c_i + T_end opaque`, T the product
//!   of all nearer tau. No capacity limits it. Order is by depth along the axis of view, then the higher priority, then the
//!   lower number. Before everything lie overlays, by priority; behind everything discs of the sky, then stars. Against the
//!   opaque picture, whose priority is 0, depth decides as it does for bodies, `COINCIDENCE` included.
//! - **Place.** True perspective under every projection law, as bodies have it. A lamp stands lower by the drop of the lunoid at
//!   its own place, a sheet as a whole by that at the mean of its corners. What is less than 1 mm ahead of the eye is cut off;
//!   so is what is no number.
//! - **Area.** A thing takes part in a pixel by the area that it covers of it, in closed form: polygons by clipping, discs of
//!   lamps and stars by sectors and triangles. The pixel rule decides the opaque part alone.
//! - **Lamps.** A disc of `p = D F / d`, d the distance, F the focal length in pixels (geometric mean of both directions where
//!   pixels are not square, so that areas are right). Below 1.5 pixels the disc stays and its intensity falls, so that light is
//!   `I0 pi p^2 / 4` at every distance. `tau = 1 - min(I, 1)`, and it adds `I c`, above 1 too.
//! - **Stars.** The same disc by magnitude: intensity 1 on the least disc at `display.white_magnitude`, and brighter ones grow. Only
//!   sky shows them.
//! - **Calligraphic points.** A Gaussian spot of 0.6 pixel over the finished picture: intensity times area times the share of the
//!   disc's area on the screen that is not hidden, dimmed by what is nearer. They hide each other and nothing else.
//! - **Sheets.** Their share along the ray of the pixel's centre: constant, or `exp(-kappa s)` of dust.
//! - **Discs of the sky** are opaque and seen where a ray meets no ground, body or silhouette.
//!
//! # Planes
//!
//! `intensity` follows the pixel rule. All others are of the pixel's centre: `range` (m, along the ground from the
//! eye's nadir; infinite in the sky and on silhouettes), `height` (m above the tangent plane), `normal_*` (unit, outwards,
//! of terrain and craters together or of the face, whatever light a law gives them), `reflectivity` (before remote
//! shadow and texture), `shadow` (local before remote; 0 in the sky and on silhouettes), `label` (track before crater
//! before terrain). In the sky, and for height and normal of silhouettes, the value is 0. Values are rounded to f32;
//! the places they tell of are good to rounding.
//!
//! Effects are in `intensity` and colour, which may exceed 1. A light point, a sheet or an overlay is the `label` where more
//! than half of the weight at the centre is its own. All other planes are of the opaque picture.
//!
//! # Method
//!
//! Within a region terrain along a line is a polynomial of degree 10, of degree 15 where two levels fade. A plane above
//! each region, from the patch's Bernstein control heights, tells most regions that the line stays above them; bounds
//! over blocks of 8 and 64 regions pass over more. Craters lie in a grid of cells with the most they can add. In a
//! cell that the line may meet it is cut at every circle it crosses: between them a crater adds a quadratic in s and,
//! on walls and rims, a multiple of its distance rho(s), which is convex.
//!
//! Without rho, G is taken in Bernstein form: coefficients of one sign prove that there is no root, one change of sign
//! proves one root (Newton within its bracket), and anything else is halved. With it, chord and tangent of each rho
//! bound G and its derivative: a bound below 0 proves that there is no root, a derivative of one sign that there is at
//! most one, and anything else is halved. A touch that 50 halvings cannot tell from a root counts as one. Nothing is
//! sampled, so no ridge and no rim is stepped over; roots are good to rounding, 1e-12 of the range but where the line
//! only grazes. The sphere's drop is bounded like rho. A ray straight up or down leaves the vertical by a tangent of 1e-18.
//! Where a column has one azimuth, a ray starts where the one below it ended.
//!
//! The quadrature looks at five places of a line, then wherever they disagree. It is told where edges of bodies cross
//! the column, so a body thinner than a line has its share. A shadow, a patch or a crater that covers less than a quarter
//! of a line between two such places, with equal light around it, can be missed: by at most that quarter's share.
//! Texture is followed the same way: grain finer than a quarter of a line may be averaged with an error of its
//! amplitude.
//!
//! Of a pixel with effects the opaque picture is looked at in its centre and corners. If order and visibility are the same
//! in all five, and no more than one thing that is seen covers the pixel in part, areas say all, and nothing is sampled.
//! Otherwise there are [`SUB_RAYS`] sub-rays, of which every column and line of 1/64 pixel has one: an edge along an axis is
//! met to 1/128 of a pixel, any straight edge to 1/14 of its area, 0.013 root mean square. What a thing adds stays in
//! proportion to its area. What dims the opaque picture is weighed with the light of each sub-ray. Discs of the sky are always
//! met by sub-rays. What passes between the five places of a pixel can be missed, and a disc of the sky narrower than 1/8
//! pixel.
//!
//! # Timing
//!
//! No clocks, no state between frames. Columns are drawn by the threads of the current rayon pool, each column
//! by itself, then calligraphic points in order: the bits do not depend on the number of threads. `samples` of the frame's counts
//! are rays from the eye, those behind effects included,
//! `bodies` those that the laws let be seen.
//!
//! # Not modelled
//!
//! Parts, words, scalar type, loader, sweeps, sweep memory: whatever makes a machine a machine. Levels coarser than the
//! second, for sight. Nothing can be probed.
//!
//! # Our choices
//!
//! - Ground nearer than the machine's first sample is not drawn: a ray that is under the ground there shows 0 and
//!   range infinity, and such ground hides nothing. Bodies are drawn from the eye on, however far away.
//! - Beyond the edge of the stored area there is nothing: sky. It casts no shadow either.
//! - Refused are an eye in the ground, a pose that is no number or beyond 10^9 m, and under `AsReported` a view that reaches
//!   90 degrees from the horizontal, where that law has no ray.
//! - A ray that comes from beside the area into it under its ground sees nothing, and nothing behind it.
//! - Shadow is a property of the map: where the coarse level is seen but the fine one stored, the fine one shadows.
//! - Without remote shadow in the settings there are no tracks, and no body is dark.
//! - An eye inside a body does not see it. An open surface has no inside.
//! - A face that turns from the sun may be lit where normals at its corners do not turn from it.
//! - A raster is what the planes hold.
//! - In a pixel that a ridge crosses the rule `Centre` gives the opaque picture the whole pixel, and the sky beside it its area:
//!   weights may sum to more than 1 there. Under `LineMean` they sum to 1.
//! - A disc of a lamp is a circle on the view-plane, wherever it stands.
//!
//! # See also
//!
//! `tests/pictures`: planes, the lunoid's horizon, a hidden valley, rims, shadows, boxes, fading levels and effects in closed
//! form; random ground with craters, its shadows and whole pictures against marching along each ray.

mod bend;
mod buckets;
mod ceilings;
mod column;
mod craters;
mod effects;
mod ground;
mod light;
mod line;
mod lists;
mod open_sea;
mod outlook;
mod profile;
mod relief;
mod rings;
mod scene;
mod seen;
mod session;
mod shadow;
mod stance;
mod standing;
mod view;
mod walk;
mod water_area;

pub use ceilings::Ceilings;
pub use column::{Fineness, LINE_MEAN_TOLERANCE, RIDGE_SHARE};
pub use effects::SUB_RAYS;
pub use outlook::{Outlook, Ray, Sight, Spot};
pub use session::{Columns, Exact, ExactWithin, ProfilePoint, ROW};
pub use view::View;
