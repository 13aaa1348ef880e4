relative-too_few_points = { $n } points communs sont donnés ; une orientation relative en demande six.

relative-no_solution = Aucune orientation relative ne convient à six des { $n } points à { $limit_px } px près.

relative-parallel_rays = Les rayons des points communs sont parallèles à { NUM($angle_deg, decimals: 3) }° près.
