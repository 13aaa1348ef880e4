image_list-unknown_columns = Ces noms de colonnes ne déterminent pas les coordonnées : { $names }.

image_list-unit = L'unité { $unit } n'est pas prise en charge.

image_list-order_unclear = Sans noms de colonnes, l'ordre des coordonnées { $first } est ambigu.
