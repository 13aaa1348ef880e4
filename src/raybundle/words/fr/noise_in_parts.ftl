noise_in_parts = Les écarts-types reposent sur un bruit blanc : les champs de bruit demandent les équations normales en une pièce.

noise_in_parts-factor = { $of ->
        [interior] Orientation interne
       *[points] Points objet
    } : facteur { NUM($factor, digits: 2) } (médiane, dans une partie de { $images } images).
