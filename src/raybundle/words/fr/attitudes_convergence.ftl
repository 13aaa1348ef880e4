attitudes_convergence = Les attitudes sont tournées de { NUM($about_deg, decimals: 2) }° autour de la verticale : elles se rapportent à un autre nord.
