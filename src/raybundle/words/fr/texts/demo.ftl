demo-simulated = Simulé et étalonné : { $images } images de { $n } cibles, bruit { NUM($sigma_px, digits: 2) } px.

demo-given = Donné : une base d'échelle ({ NUM($length_m, decimals: 4) } m, sigma { $sigma_mm } mm), c = { $c_mm } mm (erreur { PERCENT($error) } %).

demo-scale_bar = Base d'échelle : { NUM($length_m, decimals: 4) } m, écart-type { $sigma_mm } mm.

demo-interior = Orientation interne : les { $n } paramètres ont une erreur d'au plus { NUM($ratio, digits: 2) } sigma ({ $symbol }).

demo-points = { $kind ->
        [targets] Cibles
        *[other] Centres de projection
    } : erreur vraie { NUM($rms_mm, digits: 2) } mm (EMQ), annoncée { NUM($stated_mm, digits: 2) } mm.
