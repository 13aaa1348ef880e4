surface-points = Surface : { $n } points de { $maps } cartes de profondeur.

surface-photographs_missing = { $n } photographies compensées sur { $of } ne sont pas utilisables : { $names }.

surface-other_photographs = Des photographies ne sont pas les fichiers qui ont été orientés.

surface-precision = Écart-type d'un point : { NUM($median, digits: 2) } { $free_scale ->
        [yes] unités (médiane, échelle arbitraire)
        *[no] { $unit } (médiane)
    }.

surface-precision_of_axes = Écart-type médian : X { $x }, Y { $y }, Z { $z }, le long du rayon { $along_ray } { $unit }.

surface-shares = Variance le long du rayon : bruit { $noise } %, rugosité { $roughness } %, orientation { $orientation } %.
