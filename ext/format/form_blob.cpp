#include "format/form_blob.h"

#include "format/crc32c.h"
#include "format/node_format.h"
#include "shape/mesh/shared_mesh.h"
#include "shape/outline/shared_outline.h"

namespace foresee {

namespace {

constexpr std::uint8_t format = 1;

}  // namespace

std::vector<std::byte> form_blob_of(FormKind kind, std::size_t size) {
  std::vector<std::byte> blob(size);
  store_number(blob.data(), format);
  store_number(blob.data() + 1, kind);
  return blob;
}

void seal_form(std::span<std::byte> blob) {
  const std::size_t end = blob.size() - form_checksum_size;
  store_number(blob.data() + end, crc32c(blob.data(), end));
}

std::uint32_t checksum_of_form(std::span<const std::byte> blob) {
  return load_number<std::uint32_t>(blob.data() + blob.size() - form_checksum_size);
}

const char* form_frame_fault(std::span<const std::byte> blob) {
  if (blob.size() < form_header_size + form_checksum_size) return "it is too short";
  if (checksum_of_form(blob) != crc32c(blob.data(), blob.size() - form_checksum_size))
    return "its checksum is wrong";
  return load_number<std::uint8_t>(blob.data()) == format ? nullptr : "its format or kind is not known";
}

FormKind form_kind_of(std::span<const std::byte> blob) {
  return load_number<FormKind>(blob.data() + 1);
}

std::vector<std::byte> encode_form(const Form& form) {
  if (form.shape() == Shape::mesh) return encode_mesh(static_cast<const SharedMesh&>(form).mesh());
  const auto& shared = static_cast<const SharedOutline&>(form);
  return shared.degrees().parts() > 0 ? encode_zone(shared.degrees(), shared.outline())
                                      : encode_outline(shared.outline());
}

const char* decode_form(std::span<const std::byte> blob, Shape shape, std::shared_ptr<const Form>& form) {
  form = nullptr;
  if (shape == Shape::mesh) {
    Mesh mesh;
    if (const char* fault = decode_mesh(blob, mesh)) return fault;
    form = std::make_shared<const SharedMesh>(std::move(mesh));
  } else if (form_frame_fault(blob) == nullptr && form_kind_of(blob) == FormKind::zone) {
    Outline degrees, plane;
    if (const char* fault = decode_zone(blob, degrees, plane)) return fault;
    form = std::make_shared<const SharedOutline>(std::move(plane), std::move(degrees));
  } else {
    Outline outline;
    if (const char* fault = decode_outline(blob, outline)) return fault;
    form = std::make_shared<const SharedOutline>(std::move(outline));
  }
  return nullptr;
}

}  // namespace foresee
