relative_control = Les positions de { $photographs } photographies sur { $lines } lignes de vol sont utilisées par leurs différences.

relative_control-excluded = { $n } photographies sur aucune ligne de vol sont exclues.

relative_control-open = Sans appui en { $axes }, le décalage d'une ligne est supposé bon à { $plan_m } m en plan, { $height_m } m en altitude.
