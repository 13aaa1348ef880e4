attitudes_convergence = Die Lagewinkel sind um { NUM($about_deg, decimals: 2) }° um die Lotrichtung gedreht: Der Bezug ist eine andere Nordrichtung.
    .why = Gitternord und geographisch Nord unterscheiden sich hier in UTM um { NUM($convergence_deg, decimals: 2) }°; die Fehlausrichtung nimmt den Unterschied auf.
    .do = Prüfen, ob die Gierwinkel auf geographisch Nord oder auf Gitternord bezogen sind.
