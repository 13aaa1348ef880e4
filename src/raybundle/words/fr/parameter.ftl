parameter-unknown = { $name } n'est pas un paramètre de { $model }.

parameter-twice = Le paramètre { $name } figure deux fois.

parameter-no_list = { $value } n'est pas une liste de paramètres.

parameter-sigma_not_positive = L'écart-type de { $name } est { $sigma }.

parameter-sigma_of_fixed = { $name } a un écart-type, mais est fixé.
