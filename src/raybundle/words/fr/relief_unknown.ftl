relief_unknown = Les points de liaison n'ont pas de valeurs dans les colonnes { $columns }.
