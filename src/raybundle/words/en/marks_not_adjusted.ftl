marks_not_adjusted = The result is without the marks of this project: they cannot be adjusted with it.
    .why = The photographs were oriented anew, and the marks do not fit them.
    .do = Look at the marks in the studio, or run `raybundle mark adjust` for the details.
