observations-covariance_not_positive = Observations ({ observations-kind }) : la matrice de covariance n'est pas définie positive.

observations-none_of_kind = Le bloc { $block } n'a pas d'observations du type { $kind }.

observations-without_partials = Les observations du type { $kind } n'ont de dérivée par rapport à aucune inconnue.

observations-kind = { $kind ->
        [image_observations] points image
        [camera] points image
        [control] coordonnées d'appui
        [distances] règles
        [stations] centres de projection
        [attitudes] attitudes
        [planes] points sur des plans
        [straight_lines] points sur des droites
        [plumb_lines] points sur des verticales
        [levels] points de niveau
        [coordinates_of_networks] coordonnées de réseaux
        [deviations_of_single_images] écarts d'images
        [parameters] paramètres observés
        [relations] relations entre paramètres
        [directions] directions horizontales
        [zenith_angles] angles zénithaux
        [slope_distances] distances inclinées
       *[other] { $kind }
     }

observations-astray = Observations image derrière la caméra : { $behind } ; de points divergeant à l'infini : { $diverging }.
