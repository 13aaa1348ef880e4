relief_unknown = Les points de liaison n'ont pas de valeurs dans les colonnes { $columns }.

relief_unknown-quick = Les écarts-types des points de liaison ne contiennent pas le relief de l'objet ({ OPTION("precise", "False", flag: "quick") }).
