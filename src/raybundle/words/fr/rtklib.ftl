rtklib-datum = Les positions se rapportent au datum { $datum }.

rtklib-heights = Les hauteurs sont { $heights } ; leur géoïde n'est pas nommé.

rtklib-columns = Les colonnes sont { $names }.

rtklib-line = Une ligne commence par date et heure, ou semaine et seconde, non par { $text }.

rtklib-date = { $text } n'est pas une date valable.

rtklib-baselines = Le fichier contient des lignes de base.

rtklib-not_decimal_degrees = { $value } : les angles ne sont pas en degrés décimaux.

rtklib-beyond_degrees = Une latitude ou une longitude est hors de ± 90° ou ± 180°.

rtklib-track = Le fichier est une trace de { $n } époques sans lien avec les photographies.
