// SPDX-License-Identifier: MIT
#pragma once

#include "io/exports/export_recipe.h"

#include <QJsonObject>

#include <optional>

namespace io {

// A recipe as JSON, and back to the last bit. nullopt for what is none; ranges are not looked at.
QJsonObject recipeJson(const ExportRecipe& recipe);
std::optional<ExportRecipe> recipeIn(const QJsonObject& json);

} // namespace io
