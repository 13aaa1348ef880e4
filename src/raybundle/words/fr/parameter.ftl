parameter-unknown = { $name } n'est pas un paramètre de { $model }.

parameter-twice = Le paramètre { $name } figure deux fois.

parameter-no_list = { $value } n'est pas une liste de paramètres.

parameter-sigma_not_positive = L'écart-type de { $name } est { $sigma }.

parameter-sigma_of_fixed = { $name } a un écart-type, mais est fixé.

parameter-unknown_camera = { $way ->
        [free] { OPTION("free") }
       *[hold] { OPTION("hold") }
     } : la caméra { $camera } n'est pas dans le bloc.

parameter-free_and_held = Le paramètre { $symbol } de la caméra { $camera } est choisi libre et fixe à la fois.

parameter-not_of_camera = { $way ->
        [free] { OPTION("free") }
       *[hold] { OPTION("hold") }
     } : la caméra { $camera } n'a pas de paramètre { $symbol }.
