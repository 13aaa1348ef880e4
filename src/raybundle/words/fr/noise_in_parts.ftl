noise_in_parts = Les écarts-types reposent sur un bruit blanc : les champs de bruit demandent les équations normales en une pièce.
