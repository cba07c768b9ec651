# Made by `python3 -m kinegraph._stub` from the JSON Schema of the mechanism file.
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, NamedTuple, Self

Schema = Mapping[str, Any]
Quantity = float | str | Decimal | Fraction

def schema() -> Schema: ...
def python_name(key: str) -> str: ...
def resolved(value: Schema) -> Schema: ...
def alternatives(value: Schema) -> Iterator[Schema]: ...
def forms(value: Schema) -> list[Schema]: ...
def leading_key(form: Schema) -> str: ...
def methods() -> tuple[Method, ...]: ...
def documentation(method: Method) -> str: ...
def circle(centre: str | Sequence[Any], radius: Quantity) -> dict[str, Any]: ...
def line(through: str | Sequence[Any], *, angle: Quantity = ..., to: str = ..., parallel: Any = ...,
         perpendicular: Any = ...) -> dict[str, Any]: ...

class Method(NamedTuple):
    name: str
    section: str
    holds: str
    entry: Schema
    leading: str = ...
    @property
    def forms(self) -> list[Schema]: ...
    @property
    def keys(self) -> dict[str, Schema]: ...
    @property
    def says(self) -> str: ...

class FileBuilder:
    def _contents(self) -> dict[str, Any]: ...
    def kinegraph(self, *value: Any) -> Self:
        """Sets 'kinegraph'. The version of the format."""
    def title(self, *value: Any, en: str = ..., it: str = ..., fr: str = ..., de: str = ...,
            es: str = ...) -> Self:
        """Sets 'title'. What the sheet is called.

        en: English.
        it: Italiano.
        fr: Français.
        de: Deutsch.
        es: Español."""
    def units(self, *value: Any, length: str = ..., angle: str = ..., angular_velocity: str = ...,
            velocity: str = ..., acceleration: str = ..., mass: str = ..., force: str = ..., moment: str = ...,
            inertia: str = ..., pressure: str = ...) -> Self:
        """Sets 'units'. The units of bare numbers and of what is printed. Results in JSON are SI always.

        length: One of m, cm, mm, in, ft (`·`, space and * are alike, ² is ^2, ° is deg). Default: m.
        angle: One of deg, rad, rev (`·`, space and * are alike, ² is ^2, ° is deg). Default: deg.
        angular_velocity: One of rad/s, rpm, deg/s, rev/s (`·`, space and * are alike, ² is ^2, ° is deg).
            Default: rad/s.
        velocity: One of m/s, cm/s, mm/s, in/s, ft/s, km/h (`·`, space and * are alike, ² is ^2, ° is deg).
            Default: m/s.
        acceleration: One of m/s², cm/s², mm/s², in/s², ft/s² (`·`, space and * are alike, ² is ^2, ° is deg).
            Default: m/s².
        mass: One of kg, g, t, lb, oz, slug, lb s²/in (`·`, space and * are alike, ² is ^2, ° is deg). Default:
            kg.
        force: One of N, kN, MN, lbf, kgf (`·`, space and * are alike, ² is ^2, ° is deg). Default: N.
        moment: One of N m, N cm, N mm, kN m, lbf in, lbf ft (`·`, space and * are alike, ² is ^2, ° is deg).
            Default: N m.
        inertia: One of kg m², kg cm², kg mm², lb in s², lb in², lb ft², slug ft² (`·`, space and * are alike, ²
            is ^2, ° is deg). Default: kg m².
        pressure: One of Pa, kPa, MPa, GPa, bar, psi (`·`, space and * are alike, ² is ^2, ° is deg). Default:
            Pa. If not set, printed in the multiple that suits."""
    def parameter(self, name: str | int, *value: Any) -> Self:
        """Adds to 'parameters', under a name. Name → value: a number, a quantity with its unit, or a formula of
        other parameters."""
    def precision(self, *value: Any) -> Self:
        """Sets 'precision'. How far coordinates and lengths may be off: what lies within it is meant. 0: decimals
        are exact as written. m, cm, mm, in, ft."""
    def frame(self, *value: Any) -> Self:
        """Sets 'frame'. The name of the frame, "0" if left out; it needs no entry in bodies."""
    def point(self, name: str | int, *value: Any, from_: str = ..., distance: Quantity = ...,
            angle: Quantity = ..., relative_to: Sequence[Any] = ..., to: str = ..., ratio: Quantity = ...,
            meet: Sequence[Any] = ..., near: Sequence[Any] = ...,
            side: Literal['left', 'right', 'behind', 'ahead'] = ...) -> Self:
        """Adds to 'points', under a name. How a point is placed.

        from_: The point from which the distance is taken.
        distance: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        angle: An angle, counter-clockwise positive. A bare number is in the unit that "units" sets; a string
            states its own unit (deg, rad, rev), or is a formula "= …".
        relative_to: The angle counts from this direction instead of +x.
        to: The point towards which it is taken.
        ratio: In lengths of the join from → to; negative allowed.
        meet: The two curves.
        near: Of two intersections, the nearer to this place.
        side: Of two intersections: of circles the one left or right of first centre → second; on a line the one
            behind or ahead in the line's direction (left is behind, right ahead)."""
    def body(self, name: str | int, *value: Any, points: Sequence[Any] = ...,
            label: Mapping[str, Any] | str = ..., circle: Mapping[str, Any] = ..., colour: str = ...) -> Self:
        """Adds to 'bodies', under a name. A body: the points that move with it, or an object.

        points: The points that move with it.
        label: A text, or one for each language.
        circle: A disc, a wheel, a pitch circle.
        colour: The body's colour in all figures, in place of the theme's."""
    def joint(self, *entries: Any, revolute: str = ..., bodies: Sequence[Any] = ..., name: str = ...,
            prismatic: str = ..., along: Quantity | Sequence[Any] = ..., pin_slot: str = ..., arc: str = ...,
            rolling: str = ..., profiles: Mapping[str, Any] = ..., tangent: Quantity | Sequence[Any] = ...,
            materials: Literal['steel', 'stainless steel', 'cast iron', 'bronze', 'brass', 'aluminium',
            'titanium', 'glass', 'nylon'] | Mapping[str, Any] = ..., length: Quantity = ..., contact: str = ...,
            pushes: Sequence[Any] = ..., gear: str = ..., pressure_angle: Quantity = ..., arm: int | str = ...,
            weld: str = ...) -> Self:
        """Adds to 'joints'. A joint between bodies.

        revolute: The name of a point.
        bodies: Two bodies or more.
        name: What results and references call the joint; else it goes by its point's name.
        prismatic: The name of a point.
        along: The direction of the guide.
        pin_slot: The name of a point.
        arc: The centre of a curved slot.
        rolling: The name of a point.
        profiles: Body → what it shows at the contact; a body with a circle needs no entry.
        tangent: The common tangent, instead of profiles; serves velocities and forces only.
        materials: Hertzian contact under the force found: one material for both bodies, or by body. With
            "length".
        length: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        contact: The name of a point.
        pushes: One-sided: the sense of the force on i.
        gear: The name of a point.
        pressure_angle: An angle, counter-clockwise positive. A bare number is in the unit that "units" sets; a
            string states its own unit (deg, rad, rev), or is a formula "= …".
        arm: The carrier, when it is not the frame.
        weld: The name of a point."""
    def driver(self, *entries: Any, body: int | str = ..., relative_to: int | str = ..., omega: Quantity = ...,
            alpha: Quantity = ..., law: Mapping[str, Any] | Sequence[Any] = ..., drawn_at: Quantity = ...,
            joint: str = ..., speed: Quantity = ..., acceleration: Quantity = ..., at: str = ...,
            along: Quantity | Sequence[Any] = ...) -> Self:
        """Adds to 'drivers'. A given motion; what is left out is zero.

        body: The body that is driven (or give "joint").
        relative_to: The frame if left out.
        omega: An angular velocity, counter-clockwise positive. A bare number is in the unit that "units" sets;
            a string states its own unit (rad/s, rpm, deg/s, rev/s), or is a formula "= …".
        alpha: An angular acceleration, counter-clockwise positive. A bare number is in rad/s²; a string states
            its own unit (rad/s², deg/s², rpm/s), or is a formula "= …".
        law: A law of motion, from which the rates follow: one piece, or several one after the other.
        drawn_at: When, in the law, the drawn position is; its beginning if left out. s, ms, min, h.
        joint: The name of a prismatic joint or of a straight pin-slot.
        speed: A velocity. A bare number is in the unit that "units" sets; a string states its own unit (m/s,
            cm/s, mm/s, in/s, ft/s, km/h), or is a formula "= …".
        acceleration: An acceleration. A bare number is in the unit that "units" sets; a string states its own
            unit (m/s², cm/s², mm/s², in/s², ft/s²), or is a formula "= …".
        at: The point that is driven.
        along: The direction in which it is driven."""
    def mass(self, name: str | int, *value: Any, mass: Quantity = ..., centre: str = ...,
            inertia: Quantity = ...) -> Self:
        """Adds to 'masses', under a name. Mass, centre of mass and moment of inertia about it.

        mass: A mass. A bare number is in the unit that "units" sets; a string states its own unit (kg, g, t,
            lb, oz, slug, lb s²/in), or is a formula "= …".
        centre: The centre of mass.
        inertia: About the centre of mass. kg m², kg cm², kg mm², lb in s², lb in², lb ft², slug ft²."""
    def gravity(self, *value: Any) -> Self:
        """Sets 'gravity'. [gx, gy]; none if left out."""
    def inertia_forces(self, *value: Any) -> Self:
        """Sets 'inertia forces'. Whether −m·a_G and −J_G·α act."""
    def load(self, *entries: Any, force: str = ..., body: int | str = ..., at: str = ...,
            value: Sequence[Any] = ..., magnitude: Quantity = ..., along: Quantity | Sequence[Any] = ...,
            pressure: Quantity = ..., area: Quantity = ..., pin: str = ..., couple: str = ...,
            distributed: str = ..., from_: str = ..., to: str = ..., intensity: Sequence[Any] = ...,
            bodies: Sequence[Any] = ..., between: Sequence[Any] = ..., spring: str = ...,
            stiffness: Quantity = ..., free_length: Quantity = ..., turned: Quantity = ...) -> Self:
        """Adds to 'loads'. A given force or couple.

        force: The force's name (or "couple").
        body: The body on which it acts.
        at: The point at which it acts.
        value: The components [Fx, Fy].
        magnitude: A force. A bare number is in the unit that "units" sets; a string states its own unit (N, kN,
            MN, lbf, kgf), or is a formula "= …".
        along: The direction of the force.
        pressure: A pressure. A bare number is in the unit that "units" sets; a string states its own unit (Pa,
            kPa, MPa, GPa, bar, psi), or is a formula "= …".
        area: An area. A bare number is in m²; a string states its own unit (m², cm², mm², in²), or is a formula
            "= …".
        pin: A hinge, by its name or its point.
        couple: A name: no comma, no " on ", no control character.
        distributed: A name: no comma, no " on ", no control character.
        from_: The point where it begins.
        to: The point where it ends.
        intensity: The intensities at both ends, [q0, q1].
        bodies: The two bodies i, j.
        between: The two points at which they are pulled.
        spring: A name: no comma, no " on ", no control character.
        stiffness: A force per length. A bare number is in N/m; a string states its own unit (N/m, N/cm, N/mm,
            kN/m, lbf/in, lbf/ft, kgf/m), or is a formula "= …".
        free_length: A length. A bare number is in the unit that "units" sets; a string states its own unit (m,
            cm, mm, in, ft), or is a formula "= …".
        turned: An angle, counter-clockwise positive. A bare number is in the unit that "units" sets; a string
            states its own unit (deg, rad, rev), or is a formula "= …"."""
    def effort(self, *entries: Any, couple: str = ..., body: int | str = ..., from_: int | str = ...,
            force: str = ..., at: str = ..., along: Quantity | Sequence[Any] = ..., joint: str = ...) -> Self:
        """Adds to 'effort'. An unknown force or couple that balances.

        couple: A name: no comma, no " on ", no control character.
        body: The body on which it acts.
        from_: The body from which it acts; the frame if left out.
        force: The force's name.
        at: The point at which it acts.
        along: The direction of the force.
        joint: The name of a prismatic joint."""
    def motion(self, *value: Any, body: int | str = ..., velocities: Mapping[str, Any] = ...,
            accelerations: Mapping[str, Any] = ..., point: str = ..., x: Quantity = ..., y: Quantity = ...,
            r: Quantity = ..., theta: Quantity = ..., path: Mapping[str, Any] = ..., s: Quantity = ...,
            at: Quantity = ..., from_: Quantity = ..., to: Quantity = ...,
            constants: Mapping[str, Any] = ...) -> Self:
        """Sets 'motion'.

        body: The body that moves.
        velocities: Point → [vx, vy] or {"along": X}.
        accelerations: Point → [ax, ay] or {"along": X}.
        point: The point's name. Default: P.
        x: An expression in t (of a path in x): + - * / ^, brackets, numbers with units, constants, pi, sqrt,
            sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log.
        y: An expression in t (of a path in x): + - * / ^, brackets, numbers with units, constants, pi, sqrt,
            sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log.
        r: An expression in t (of a path in x): + - * / ^, brackets, numbers with units, constants, pi, sqrt,
            sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log.
        theta: An expression in t (of a path in x): + - * / ^, brackets, numbers with units, constants, pi,
            sqrt, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log.
        path: What the point moves along; s is its law.
        s: An expression in t (of a path in x): + - * / ^, brackets, numbers with units, constants, pi, sqrt,
            sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, log.
        at: The instant. s, ms, min, h.
        from_: Where the interval begins. Default: 0 s. s, ms, min, h.
        to: Where the interval ends. s, ms, min, h.
        constants: Name → number, quantity or formula."""
    def find(self, *entries: Any, relative_motion: str = ..., observer: Mapping[str, Any] | int | str = ...,
            solve: bool = ..., cut: Sequence[Any] = ...) -> Self:
        """Adds to 'find'. What to find; without it, all that the data allow.

        relative_motion: The point whose motion is observed.
        observer: A body that carries the observer, or a point with which the observer translates.
        solve: Whether the motion itself is to be found through this observer, on a body.
        cut: Three bars of a truss, each named by its pins, that part it (Ritter)."""
    def scales(self, *value: Any, mechanism: str = ..., centres: str = ..., velocity: str = ...,
            acceleration: str = ..., body: str = ..., forces: str = ..., closure: str = ...) -> Self:
        """Sets 'scales'. Figure → scale; else chosen.

        mechanism: A scale such as "1:5" or "1 mm = 0.1 m".
        centres: A scale such as "1:5" or "1 mm = 0.1 m".
        velocity: A scale such as "1 mm = 0.1 m/s".
        acceleration: A scale such as "1 mm = 0.1 m/s²".
        body: A scale such as "1 mm = 0.1 N".
        forces: A scale such as "1 mm = 0.1 N".
        closure: A scale such as "1 mm = 0.1 N"."""
    def hertz(self, *value: Any, force: Quantity = ..., bodies: Mapping[str, Any] = ...,
            contact: Literal['point', 'line'] = ..., length: Quantity = ..., turned: Quantity = ...) -> Self:
        """Sets 'hertz'. Two elastic bodies pressed together (Hertz), in place of joints.

        force: A force. A bare number is in the unit that "units" sets; a string states its own unit (N, kN, MN,
            lbf, kgf), or is a formula "= …".
        bodies: The two bodies by name.
        contact: Default: point.
        length: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        turned: An angle, counter-clockwise positive. A bare number is in the unit that "units" sets; a string
            states its own unit (deg, rad, rev), or is a formula "= …"."""
    def reye(self, *value: Any, kind: Literal['pad'] = ..., force: Quantity = ..., friction: Quantity = ...,
            wear: Quantity = ..., time: Quantity = ..., length: Quantity = ..., width: Quantity = ...,
            offset: Quantity = ..., speed: Quantity = ..., inner: Quantity = ..., outer: Quantity = ...,
            surfaces: Quantity = ..., omega: Quantity = ..., radius: Quantity = ..., pivot: Quantity = ...,
            arm: Quantity = ..., from_: Quantity = ..., to: Quantity = ..., inside: bool = ...,
            sense: Literal['leading', 'trailing'] = ...) -> Self:
        """Sets 'reye'. A rubbing contact and its wear (Reye), in place of joints.

        kind: What rubs.
        force: A force. A bare number is in the unit that "units" sets; a string states its own unit (N, kN, MN,
            lbf, kgf), or is a formula "= …".
        friction: Coefficient of friction.
        wear: Coefficient of wear. m²/N, mm²/N, mm³/(N m).
        time: A time. A bare number is in s; a string states its own unit (s, ms, min, h), or is a formula "=
            …".
        length: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        width: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        offset: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        speed: A velocity. A bare number is in the unit that "units" sets; a string states its own unit (m/s,
            cm/s, mm/s, in/s, ft/s, km/h), or is a formula "= …".
        inner: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        outer: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        surfaces: How many rub. Default: 1.
        omega: An angular velocity, counter-clockwise positive. A bare number is in the unit that "units" sets;
            a string states its own unit (rad/s, rpm, deg/s, rev/s), or is a formula "= …".
        radius: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        pivot: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        arm: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm, mm,
            in, ft), or is a formula "= …".
        from_: An angle, counter-clockwise positive. A bare number is in the unit that "units" sets; a string
            states its own unit (deg, rad, rev), or is a formula "= …".
        to: An angle, counter-clockwise positive. A bare number is in the unit that "units" sets; a string
            states its own unit (deg, rad, rev), or is a formula "= …".
        inside: The shoe lies within the drum.
        sense: Default: leading."""
    def impact(self, *value: Any, bodies: Mapping[str, Any] = ..., at: Sequence[Any] | str = ...,
            normal: Quantity | Sequence[Any] = ..., restitution: Quantity = ...,
            friction: Quantity = ...) -> Self:
        """Sets 'impact'. Two rigid bodies that hit each other, in place of joints.

        bodies: The two bodies by name.
        at: The point of impact, a point or [x, y].
        normal: The direction of the line of impact.
        restitution: From 0 to 1.
        friction: Coefficient of friction. Default: 0."""
    def rotor(self, *value: Any, planes: Mapping[str, Any] = ..., masses: Mapping[str, Any] = ...,
            correction: Sequence[Any] = ..., bearings: Sequence[Any] = ..., omega: Quantity = ...) -> Self:
        """Sets 'rotor'. Masses on a shaft, to be balanced in one plane or two, in place of joints.

        planes: Name → its place z along the shaft.
        masses: Name → mass.
        correction: One: static balance; two: dynamic balance.
        bearings: The planes of the two bearings.
        omega: With bearings: the speed at which they are loaded. rad/s, rpm, deg/s, rev/s."""
    def positions(self, *value: Any) -> Self:
        """Sets 'positions'. Two or three positions of a body by the places of two of its points; further ones also
        by the first point and "turned"."""
    def ask(self, *entries: Any) -> Self:
        """Adds to 'ask'. The results that are asked for, by the names of the columns of a sweep: "v B", "omega 3",
        "effort M"."""
    def vary(self, name: str | int, *value: Any, from_: Quantity = ..., to: Quantity = ...,
            step: Quantity = ..., choose: Sequence[Any] = ...) -> Self:
        """Adds to 'vary', under a name. Parameter → the values that it takes from copy to copy of an exercise
        (kinegraph variants).

        from_: The first value (or give "choose").
        to: The last value.
        step: From one value to the next.
        choose: The values."""
    def require(self, *entries: Any) -> Self:
        """Adds to 'require'. Conditions that every copy meets: "omega 3 > 0.2", "vx B between 0.1 m/s and 1 m/s",
        "crank turns fully", "velocity polygon readable"."""
    def position_of_cam(self, *value: Any) -> Self:
        """Sets 'position of cam'. The cam file of which this is one position: the circle of curvature stands in
        place of the profile, and the mechanism is not moved."""
    def revolute(self, revolute: Any, *more: Any, bodies: Sequence[Any] = ..., name: str = ...) -> Self:
        """Adds to 'joints'. A hinge.

        bodies: Two bodies or more.
        name: What results and references call the joint; else it goes by its point's name."""
    def prismatic(self, prismatic: Any, *more: Any, bodies: Sequence[Any] = ...,
            along: Quantity | Sequence[Any] = ..., name: str = ...) -> Self:
        """Adds to 'joints'. A slider or sleeve: j carries the guide, which passes through the point along X.

        bodies: The two bodies i, j.
        along: The direction of the guide.
        name: What results and references call the joint; else it goes by its point's name."""
    def pin_slot(self, pin_slot: Any, *more: Any, bodies: Sequence[Any] = ...,
            along: Quantity | Sequence[Any] = ..., arc: str = ..., name: str = ...) -> Self:
        """Adds to 'joints'. A pin of i in a slot of j, straight ("along") or curved ("arc").

        bodies: The two bodies i, j.
        along: A direction: an angle from +x, two points (first → second), or a vector [dx, dy].
        arc: The centre of a curved slot.
        name: What results and references call the joint; else it goes by its point's name."""
    def rolling(self, rolling: Any, *more: Any, bodies: Sequence[Any] = ..., profiles: Mapping[str, Any] = ...,
            tangent: Quantity | Sequence[Any] = ..., materials: Literal['steel', 'stainless steel', 'cast iron',
            'bronze', 'brass', 'aluminium', 'titanium', 'glass', 'nylon'] | Mapping[str, Any] = ...,
            length: Quantity = ..., name: str = ...) -> Self:
        """Adds to 'joints'. Rolling without slip.

        bodies: The two bodies i, j.
        profiles: Body → what it shows at the contact; a body with a circle needs no entry.
        tangent: The common tangent, instead of profiles; serves velocities and forces only.
        materials: Hertzian contact under the force found: one material for both bodies, or by body. With
            "length".
        length: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        name: What results and references call the joint; else it goes by its point's name."""
    def contact(self, contact: Any, *more: Any, bodies: Sequence[Any] = ..., profiles: Mapping[str, Any] = ...,
            tangent: Quantity | Sequence[Any] = ..., pushes: Sequence[Any] = ..., materials: Literal['steel',
            'stainless steel', 'cast iron', 'bronze', 'brass', 'aluminium', 'titanium', 'glass', 'nylon'] |
            Mapping[str, Any] = ..., length: Quantity = ..., name: str = ...) -> Self:
        """Adds to 'joints'. A sliding contact.

        bodies: The two bodies i, j.
        profiles: Body → what it shows at the contact; a body with a circle needs no entry.
        tangent: The common tangent, instead of profiles; serves velocities and forces only.
        pushes: One-sided: the sense of the force on i.
        materials: Hertzian contact under the force found: one material for both bodies, or by body. With
            "length".
        length: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        name: What results and references call the joint; else it goes by its point's name."""
    def gear(self, gear: Any, *more: Any, bodies: Sequence[Any] = ..., profiles: Mapping[str, Any] = ...,
            tangent: Quantity | Sequence[Any] = ..., pressure_angle: Quantity = ..., arm: int | str = ...,
            materials: Literal['steel', 'stainless steel', 'cast iron', 'bronze', 'brass', 'aluminium',
            'titanium', 'glass', 'nylon'] | Mapping[str, Any] = ..., length: Quantity = ...,
            name: str = ...) -> Self:
        """Adds to 'joints'. Pitch curves that touch at the pitch point.

        bodies: The two bodies i, j.
        profiles: Body → what it shows at the contact; a body with a circle needs no entry.
        tangent: The common tangent, instead of profiles; serves velocities and forces only.
        pressure_angle: An angle, counter-clockwise positive. A bare number is in the unit that "units" sets; a
            string states its own unit (deg, rad, rev), or is a formula "= …".
        arm: The carrier, when it is not the frame.
        materials: Hertzian contact under the force found: one material for both bodies, or by body. With
            "length".
        length: A length. A bare number is in the unit that "units" sets; a string states its own unit (m, cm,
            mm, in, ft), or is a formula "= …".
        name: What results and references call the joint; else it goes by its point's name."""
    def weld(self, weld: Any, *more: Any, bodies: Sequence[Any] = ..., name: str = ...) -> Self:
        """Adds to 'joints'. Clamped.

        bodies: The two bodies i, j.
        name: What results and references call the joint; else it goes by its point's name."""
    def distributed(self, distributed: Any, *more: Any, body: int | str = ..., from_: str = ..., to: str = ...,
            intensity: Sequence[Any] = ..., along: Quantity | Sequence[Any] = ...) -> Self:
        """Adds to 'loads'. A load along PQ; its intensity runs straight from q0 at P to q1 at Q.

        body: The body on which it acts.
        from_: The point where it begins.
        to: The point where it ends.
        intensity: The intensities at both ends, [q0, q1].
        along: The direction of the load."""
    def spring(self, spring: Any, *more: Any, bodies: Sequence[Any] = ..., between: Sequence[Any] = ...,
            stiffness: Quantity = ..., free_length: Quantity = ..., at: str = ...,
            turned: Quantity = ...) -> Self:
        """Adds to 'loads'. An elastic spring: pulls with k (l - l0). A torsion spring: turns i back with k times
        its turn against j.

        bodies: The two bodies i, j.
        between: The two points at which they are pulled.
        stiffness: A force per length. A bare number is in N/m; a string states its own unit (N/m, N/cm, N/mm,
            kN/m, lbf/in, lbf/ft, kgf/m), or is a formula "= …".
        free_length: A length. A bare number is in the unit that "units" sets; a string states its own unit (m,
            cm, mm, in, ft), or is a formula "= …".
        at: The point about which it is wound.
        turned: An angle, counter-clockwise positive. A bare number is in the unit that "units" sets; a string
            states its own unit (deg, rad, rev), or is a formula "= …"."""
    def relative_motion(self, relative_motion: Any, *more: Any, observer: Mapping[str, Any] | int | str = ...,
            solve: bool = ...) -> Self:
        """Adds to 'find'. What to find; without it, all that the data allow.

        observer: A body that carries the observer, or a point with which the observer translates.
        solve: Whether the motion itself is to be found through this observer, on a body."""
    def cut(self, cut: Any, *more: Any) -> Self:
        """Adds to 'find'. What to find; without it, all that the data allow."""
    def link(self, name: str | int, *value: Any, points: Sequence[Any] = ...,
            label: Mapping[str, Any] | str = ..., circle: Mapping[str, Any] = ..., colour: str = ...) -> Self:
        """Adds to 'bodies', under a name. A body: the points that move with it, or an object.

        points: The points that move with it.
        label: A text, or one for each language.
        circle: A disc, a wheel, a pitch circle.
        colour: The body's colour in all figures, in place of the theme's."""
