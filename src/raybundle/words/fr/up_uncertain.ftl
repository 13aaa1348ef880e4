up_uncertain = La verticale est incertaine de ± { NUM($sigma_deg, decimals: 0) }° : elle vient de la tenue de l'appareil.
