// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ContourShader.h"

#include "SheetNormals.h"

#include "vtkActor.h"
#include "vtkShaderProperty.h"

#include <string>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void DrawContours(vtkActor* actor)
{
  vtkShaderProperty* const shader = actor->GetShaderProperty();
  if (shader->GetNumberOfShaderReplacements() > 0)
  {
    return; // They remain, unless ParaView's property of shaders is used.
  }
  const std::string unknown = "-" + std::to_string(SheetLevels);
  shader->AddVertexShaderReplacement(
    "//VTK::PositionVC::Dec", true, "//VTK::PositionVC::Dec\nout float horizonLevel;\n", false);
  shader->AddVertexShaderReplacement(
    "//VTK::Normal::Impl", true, "horizonLevel = " + unknown + ";\n  //VTK::Normal::Impl\n", false);
  // VTK's own text, which is only there if data have normals.
  const std::string normal = "normalVCVSOutput = normalMatrix * normalMC;";
  shader->AddVertexShaderReplacement(
    normal, false, normal + "\n  horizonLevel = length(normalMC) + (" + unknown + ");\n", false);
  shader->AddFragmentShaderReplacement(
    "//VTK::PositionVC::Dec", true, "//VTK::PositionVC::Dec\nin float horizonLevel;\n", false);
  // Widths are in pixels. A level area has no contour, although its height may be a multiple of the interval. Where
  // contours come too close to each other they fade, and the bold contours fade last.
  shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true,
    "//VTK::Light::Impl\n"
    "  if (horizonLevel > -450.0)\n"
    "  {\n"
    "    float perPixel = max(fwidth(horizonLevel), 1e-7);\n"
    "    float offset = abs(fract(horizonLevel + 0.5) - 0.5) / perPixel;\n"
    "    float offsetBold = abs(fract(horizonLevel / 5.0 + 0.5) - 0.5) * 5.0 / perPixel;\n"
    "    float thin = 0.65 * (1.0 - smoothstep(0.4, 1.1, offset)) * (1.0 - smoothstep(0.15, 0.35, perPixel));\n"
    "    float bold = 0.9 * (1.0 - smoothstep(1.0, 1.7, offsetBold)) * (1.0 - smoothstep(0.75, 1.75, perPixel));\n"
    "    bool isDark = dot(ambientColor + diffuseColor, vec3(0.3, 0.6, 0.1)) < 0.3;\n"
    "    vec3 color = isDark ? vec3(0.75, 0.8, 0.85) : vec3(0.08, 0.07, 0.06);\n"
    "    float share = max(thin, bold) * smoothstep(2e-5, 1e-4, perPixel);\n"
    "    fragOutput0.rgb = mix(fragOutput0.rgb, color, share);\n"
    "  }\n",
    false);
}
}
