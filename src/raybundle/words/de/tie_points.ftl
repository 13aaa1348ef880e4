tie_points-too_few_rays = { $n } { $n ->
        [one] Verknüpfungspunkt hat
       *[other] Verknüpfungspunkte haben
     } weniger als zwei Strahlen.
    .do = Diese Punkte aus points.csv und observations.csv entfernen oder in mehr Bildern messen.

tie_points-no_ray = Kein Strahl: { LIST($points, most: 10) }

tie_points-single_ray = Ein einziger Strahl: { LIST($points, most: 10) }
