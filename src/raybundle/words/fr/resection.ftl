resection-too_few_points = { $n } points sont donnés ; un relèvement en demande trois.

resection-in_line = Les points du relèvement sont alignés.

resection-no_fit = Aucune orientation ne convient à quatre des points à { $limit_px } px près.

resection-no_solution = Aucune orientation ne projette les points là où ils ont été mesurés.
