dlt-too_few_points = { $n } points sont donnés ; une DLT en demande six, hors d'un même plan.

dlt-plane = Les points sont dans un plan (profondeur { NUM($ratio, digits: 2) } de leur étendue).

dlt-behind = La DLT place les points derrière la caméra.
