control_sigma = Les points d'appui n'ont pas d'écarts-types ; { $plan_m } m en plan est supposé, selon leur accord.
