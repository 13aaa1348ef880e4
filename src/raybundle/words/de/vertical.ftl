vertical-unknown_way = { OPTION("up") } ist { $way }.
    .do = auto, terrestrial, aerial, oblique oder zwei Punkte A,B von { OPTION("control") } angeben, B lotrecht über A.

vertical-point_without_place = { OPTION("up") }: Punkt { $point } hat keine Koordinaten.
    .do = Ihn in zwei Aufnahmen messen ({ OPTION("control") }).

vertical-same_place = { OPTION("up") }: Die Punkte { $first } und { $second } liegen an derselben Stelle.
    .do = Zwei Punkte angeben, den zweiten lotrecht über dem ersten.
