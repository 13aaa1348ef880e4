tie_points-too_few_rays = { $n } { $n ->
        [one] Verknüpfungspunkt hat
       *[other] Verknüpfungspunkte haben
     } weniger als zwei Strahlen.
    .do = Diese Punkte aus points.csv und observations.csv entfernen oder in mehr Bildern messen.

tie_points-no_ray = Punkte ohne Strahl: { LIST($points, most: 10) }.

tie_points-single_ray = Punkte mit einem einzigen Strahl: { LIST($points, most: 10) }.

tie_points-no_base = Die { $n } passenden Paare von Aufnahmen haben keine Basis und unterscheiden sich nur durch eine Drehung.
    .why = Aus Aufnahmen vom selben Standpunkt lässt sich keine Tiefe bestimmen.
    .do = Zwischen Aufnahmen seitlich gehen, um ein Zehntel der Entfernung zum Objekt oder mehr.

tie_points-too_few_common = Keine zwei Aufnahmen haben genug gemeinsame Verknüpfungspunkte für eine relative Orientierung.
    .do = Scharfe Aufnahmen mit 60 % Überdeckung oder mehr und kleinen Richtungsunterschieden machen.

tie_points-none_after_cleaning = Nach dem Ausschluss falscher Zuordnungen haben keine zwei Aufnahmen genug gemeinsame Verknüpfungspunkte.
    .do = Scharfe Aufnahmen mit 60 % Überdeckung oder mehr und kleinen Richtungsunterschieden machen.
