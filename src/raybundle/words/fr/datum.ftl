datum-unknown_points = Des points de référence ne participent pas à la compensation : { LIST($points, most: 5) }.

datum-points_in_line = Les points objet ne peuvent pas définir la référence : ils sont confondus ou alignés.

datum-fixed = Les observations fixent la référence de ce bloc ; aucune autre ne peut être choisie.

datum-part = { $part ->
        [position_x] position en X
        [position_y] position en Y
        [position_z] position en Z
        [rotation_x] rotation autour de X
        [rotation_y] rotation autour de Y
        [rotation_z] rotation autour de Z
        [scale] échelle
        [about_line] rotation autour d'une droite
       *[several] plusieurs paramètres de référence
     }

datum-combination = { $n } combinaison(s) de { LIST($among, most: 7) } (t translation, r rotation, m échelle)

datum-too_few_points = { $points } points de référence ne suffisent pas pour { $constraints } contraintes internes.

datum-no_scale = Aucune observation ne détermine l'échelle.

datum-not_by_control = Non déterminé par l'appui : { datum-part }.

datum-misalignment_unknown = Non déterminé : { datum-part } ; le désalignement de la centrale inertielle est inconnu.

datum-antennas_unknown = Non déterminé : { datum-part } ; les décalages des antennes GNSS sont inconnus.

datum-directions_unknown = Non déterminé : { datum-part } ; l'orientation des tours d'horizon est inconnue.
