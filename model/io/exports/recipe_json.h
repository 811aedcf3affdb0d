// SPDX-License-Identifier: MIT
#pragma once

#include "io/exports/export_recipe.h"

#include <QJsonObject>

#include <optional>

namespace io {

// Conversion of a recipe to JSON and back, to the last bit. nullopt for JSON that is no recipe; ranges are
// not checked.
QJsonObject recipeJson(const ExportRecipe& recipe);
std::optional<ExportRecipe> recipeIn(const QJsonObject& json);

} // namespace io
