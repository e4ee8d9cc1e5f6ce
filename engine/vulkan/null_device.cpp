// SPDX-License-Identifier: GPL-3.0-or-later
#include "vulkan/null_device.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <utility>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vulkan/vulkan.h>

#include "vulkan/spirv_loops.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

/// Names the variable by which RADV is told to compile for a chip that is not there.
constexpr const char* chipVariable = "RADV_FORCE_FAMILY";

/// Calls a function when it is destroyed, for objects of C.
class AtEnd {
  public:
    AtEnd() = default;
    explicit AtEnd(std::function<void()> end) : end_(std::move(end)) {}
    AtEnd(AtEnd&& other) noexcept : end_(std::exchange(other.end_, {})) {}
    AtEnd& operator=(AtEnd&& other) noexcept {
        std::swap(end_, other.end_);
        return *this;
    }
    ~AtEnd() {
        if (end_) {
            end_();
        }
    }

  private:
    std::function<void()> end_;
};

/// Returns the file by which the loader finds RADV, which a user may name with the loader's own
/// variable; empty where it is not there.
fs::path driverManifest() {
    std::error_code ignored;
    if (const char* named = std::getenv("VK_DRIVER_FILES")) {
        return fs::exists(named, ignored) ? fs::path(named) : fs::path();
    }
    for (const char* folder :
         {"/etc/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/usr/share/vulkan/icd.d"}) {
        for (const fs::directory_entry& file : fs::directory_iterator(folder, ignored)) {
            if (file.path().filename().string().starts_with("radeon_icd")) {
                return file.path();
            }
        }
    }
    return {};
}

tl::unexpected<Error> refused(const std::string& what, VkResult result) {
    return failure("the Vulkan driver refuses " + what + " (" + std::to_string(result) + ")");
}

struct Instance {
    VkInstance handle = VK_NULL_HANDLE;
    AtEnd end;
};

Result<Instance> makeInstance() {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo wanted{};
    wanted.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    wanted.pApplicationInfo = &application;
    VkInstance instance = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateInstance(&wanted, nullptr, &instance);
        result != VK_SUCCESS) {
        return refused("to start", result);
    }
    return Instance{instance, AtEnd([instance] { vkDestroyInstance(instance, nullptr); })};
}

struct Device {
    VkDevice handle = VK_NULL_HANDLE;
    AtEnd end;
};

Result<Device> makeDevice(VkPhysicalDevice physical) {
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR statistics{};
    statistics.sType =
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
    statistics.pipelineExecutableInfo = VK_TRUE;
    VkPhysicalDeviceVulkan13Features features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    features.pNext = &statistics;
    features.dynamicRendering = VK_TRUE;
    const char* const extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    VkDeviceCreateInfo wanted{};
    wanted.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    wanted.pNext = &features;
    wanted.queueCreateInfoCount = 1;
    wanted.pQueueCreateInfos = &queue;
    wanted.enabledExtensionCount = 1;
    wanted.ppEnabledExtensionNames = &extension;
    VkDevice device = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateDevice(physical, &wanted, nullptr, &device);
        result != VK_SUCCESS) {
        return refused("a device that tells about its pipelines", result);
    }
    return Device{device, AtEnd([device] { vkDestroyDevice(device, nullptr); })};
}

/// Returns the instance's first device; null where it has none.
VkPhysicalDevice firstDevice(const Instance& instance) {
    std::uint32_t count = 1;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    vkEnumeratePhysicalDevices(instance.handle, &count, &physical);
    return count > 0 ? physical : VK_NULL_HANDLE;
}

/// Says what a driver makes of a chip.
enum class ChipAnswer { Known, Unknown, NoDriver };

/// Asks the driver whether it knows a chip. It ends the process where it does not, so that another
/// one tries; one that cannot be loaded at all lets it go on.
ChipAnswer answerAbout(const std::string& chip) {
    constexpr int noDriver = 3;
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit noCore{0, 0};
        ::setrlimit(RLIMIT_CORE, &noCore);
        ::close(STDERR_FILENO);
        ::setenv(chipVariable, chip.c_str(), 1);
        const auto instance = makeInstance();
        ::_exit(!instance ? noDriver : firstDevice(*instance) != VK_NULL_HANDLE ? 0 : 1);
    }
    int status = 1;
    ::waitpid(child, &status, 0);
    const int ended = child > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    return ended == 0          ? ChipAnswer::Known
           : ended == noDriver ? ChipAnswer::NoDriver
                               : ChipAnswer::Unknown;
}

/// Returns how many lanes the smallest waves of a device have.
std::uint32_t smallestWave(VkPhysicalDevice physical) {
    VkPhysicalDeviceVulkan13Properties newer{};
    newer.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &newer;
    vkGetPhysicalDeviceProperties2(physical, &properties);
    return newer.minSubgroupSize;
}

std::string driverVersion(VkPhysicalDevice physical) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(physical, &properties);
    return driver.driverInfo;
}

VkDescriptorType descriptorType(SpirvProgram::Resource resource) {
    switch (resource) {
    case SpirvProgram::Resource::UniformBlock:
        return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case SpirvProgram::Resource::TexelBuffer:
        return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    case SpirvProgram::Resource::Sampler:
        break;
    }
    return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
}

VkFormat attributeFormat(SpirvProgram::Attribute::Type type) {
    switch (type) {
    case SpirvProgram::Attribute::Type::Int:
        return VK_FORMAT_R32G32B32A32_SINT;
    case SpirvProgram::Attribute::Type::Uint:
        return VK_FORMAT_R32G32B32A32_UINT;
    case SpirvProgram::Attribute::Type::Float:
        break;
    }
    return VK_FORMAT_R32G32B32A32_SFLOAT;
}

double numberIn(const VkPipelineExecutableStatisticKHR& statistic) {
    switch (statistic.format) {
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
        return statistic.value.b32 != VK_FALSE ? 1.0 : 0.0;
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
        return double(statistic.value.i64);
    case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_FLOAT64_KHR:
        return statistic.value.f64;
    default:
        return double(statistic.value.u64);
    }
}

/// Is how often the driver's compiler takes a loop to run whose rounds it does not know, and one
/// within another for each round of that.
constexpr double guessedRounds[] = {1.0, 8.0, 32.0};

/// Counts how often a stage looks up texels, by the driver's listing of it. What is in a loop
/// counts as often as the driver takes it to run.
double lookUpsIn(std::string_view listing) {
    double count = 0.0;
    std::size_t depth = 0;
    for (std::size_t at = 0; at < listing.size();) {
        const std::size_t end = std::min(listing.find('\n', at), listing.size());
        const std::string_view line = listing.substr(at, end - at);
        at = end + 1;
        if (line.find("loop-exit") != std::string_view::npos && depth > 0) {
            --depth;
        }
        if (line.find("loop-header") != std::string_view::npos) {
            ++depth;
        }
        const bool isLookUp = std::ranges::any_of(
            std::array{"image_load", "image_sample", "image_gather"},
            [line](const char* word) { return line.find(word) != std::string_view::npos; });
        if (isLookUp) {
            count += guessedRounds[std::min(depth, std::size(guessedRounds) - 1)];
        }
    }
    return count;
}

int occurrences(std::string_view text, std::string_view word) {
    int count = 0;
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + word.size())) {
        ++count;
    }
    return count;
}

/// Returns a list that Vulkan fills: it is asked for the length first.
template <class Entry, class Asked>
std::vector<Entry> listed(VkDevice device, const Asked& asked, VkStructureType type,
                          VkResult (*fill)(VkDevice, const Asked*, std::uint32_t*, Entry*)) {
    std::uint32_t count = 0;
    fill(device, &asked, &count, nullptr);
    Entry empty{};
    empty.sType = type;
    std::vector<Entry> entries(count, empty);
    fill(device, &asked, &count, entries.data());
    return entries;
}

const char* stageName(VkShaderStageFlags stages) {
    return (stages & VK_SHADER_STAGE_FRAGMENT_BIT) != 0 ? "fragment" : "vertex";
}

} // namespace

class NullDevice::Implementation {
  public:
    Implementation(Instance instance, VkPhysicalDevice physical, Device device)
        : instance_(std::move(instance)), device_(std::move(device)),
          driver_(driverVersion(physical)), smallestWave_(smallestWave(physical)),
          executables_(function<decltype(executables_)>("vkGetPipelineExecutablePropertiesKHR")),
          statistics_(function<decltype(statistics_)>("vkGetPipelineExecutableStatisticsKHR")),
          listings_(
              function<decltype(listings_)>("vkGetPipelineExecutableInternalRepresentationsKHR")) {}

    const std::string& driver() const { return driver_; }

    Result<StageStatistics> compile(const SpirvProgram& program, bool countsLoops) const {
        const auto layout = setLayout(program);
        if (!layout) {
            return tl::unexpected(layout.error());
        }
        const auto whole = pipelineLayout(layout->handle);
        if (!whole) {
            return tl::unexpected(whole.error());
        }
        const auto vertex = shaderModule(program.vertex);
        const auto fragment = shaderModule(program.fragment);
        if (!vertex || !fragment) {
            return tl::unexpected(vertex ? fragment.error() : vertex.error());
        }
        // Listings take the driver longer than all else, and say nothing but which loops are left
        // and which texels are read.
        const bool hasListings =
            (countsLoops && (hasLoops(program.vertex) || hasLoops(program.fragment))) ||
            readsTexels(program.fragment);
        const auto built =
            pipeline(program, whole->handle, vertex->handle, fragment->handle, hasListings);
        return built ? Result<StageStatistics>(statisticsOf(built->handle, hasListings))
                     : tl::unexpected(built.error());
    }

  private:
    /// Owns an object of the device.
    template <class Handle>
    struct Owned {
        Handle handle = VK_NULL_HANDLE;
        AtEnd end;
    };

    template <class Handle>
    using Destroyer = void (*)(VkDevice, Handle, const VkAllocationCallbacks*);

    template <class Handle>
    Result<Owned<Handle>> owned(VkResult result, Handle handle, Destroyer<Handle> destroy,
                                const char* what) const {
        if (result != VK_SUCCESS) {
            return refused(what, result);
        }
        const VkDevice device = device_.handle;
        return Owned<Handle>{
            handle, AtEnd([device, handle, destroy] { destroy(device, handle, nullptr); })};
    }

    template <class Function>
    Function function(const char* name) const {
        return reinterpret_cast<Function>(vkGetDeviceProcAddr(device_.handle, name));
    }

    Result<Owned<VkDescriptorSetLayout>> setLayout(const SpirvProgram& program) const {
        std::vector<VkDescriptorSetLayoutBinding> bindings;
        for (const SpirvProgram::Binding& binding : program.bindings) {
            bindings.push_back({binding.number, descriptorType(binding.resource), 1,
                                VK_SHADER_STAGE_ALL_GRAPHICS, nullptr});
        }
        VkDescriptorSetLayoutCreateInfo wanted{};
        wanted.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
        wanted.bindingCount = std::uint32_t(bindings.size());
        wanted.pBindings = bindings.data();
        VkDescriptorSetLayout layout = VK_NULL_HANDLE;
        const VkResult result =
            vkCreateDescriptorSetLayout(device_.handle, &wanted, nullptr, &layout);
        return owned(result, layout, vkDestroyDescriptorSetLayout, "the program's resources");
    }

    Result<Owned<VkPipelineLayout>> pipelineLayout(VkDescriptorSetLayout set) const {
        VkPipelineLayoutCreateInfo wanted{};
        wanted.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
        wanted.setLayoutCount = 1;
        wanted.pSetLayouts = &set;
        VkPipelineLayout layout = VK_NULL_HANDLE;
        const VkResult result = vkCreatePipelineLayout(device_.handle, &wanted, nullptr, &layout);
        return owned(result, layout, vkDestroyPipelineLayout, "the program's layout");
    }

    Result<Owned<VkShaderModule>> shaderModule(const std::vector<std::uint32_t>& words) const {
        VkShaderModuleCreateInfo wanted{};
        wanted.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        wanted.codeSize = words.size() * sizeof(std::uint32_t);
        wanted.pCode = words.data();
        VkShaderModule module = VK_NULL_HANDLE;
        const VkResult result = vkCreateShaderModule(device_.handle, &wanted, nullptr, &module);
        return owned(result, module, vkDestroyShaderModule, "the program's code");
    }

    Result<Owned<VkPipeline>> pipeline(const SpirvProgram& program, VkPipelineLayout layout,
                                       VkShaderModule vertex, VkShaderModule fragment,
                                       bool hasListings) const {
        std::array<VkPipelineShaderStageCreateInfo, 2> stages{};
        for (auto& stage : stages) {
            stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
            stage.pName = "main";
        }
        stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
        stages[0].module = vertex;
        stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
        stages[1].module = fragment;

        std::vector<VkVertexInputBindingDescription> buffers;
        std::vector<VkVertexInputAttributeDescription> attributes;
        for (const SpirvProgram::Attribute& attribute : program.attributes) {
            const auto buffer = std::uint32_t(buffers.size());
            buffers.push_back({buffer, 16, VK_VERTEX_INPUT_RATE_VERTEX});
            attributes.push_back({attribute.location, buffer, attributeFormat(attribute.type), 0});
        }
        VkPipelineVertexInputStateCreateInfo input{};
        input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
        input.vertexBindingDescriptionCount = std::uint32_t(buffers.size());
        input.pVertexBindingDescriptions = buffers.data();
        input.vertexAttributeDescriptionCount = std::uint32_t(attributes.size());
        input.pVertexAttributeDescriptions = attributes.data();

        VkPipelineInputAssemblyStateCreateInfo assembly{};
        assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
        assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;

        VkPipelineViewportStateCreateInfo viewport{};
        viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
        viewport.viewportCount = 1;
        viewport.scissorCount = 1;

        VkPipelineRasterizationStateCreateInfo raster{};
        raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
        raster.polygonMode = VK_POLYGON_MODE_FILL;
        raster.lineWidth = 1.0f;

        VkPipelineMultisampleStateCreateInfo samples{};
        samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
        samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;

        VkPipelineDepthStencilStateCreateInfo depth{};
        depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
        depth.depthTestEnable = VK_TRUE;
        depth.depthWriteEnable = VK_TRUE;
        depth.depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL;

        VkPipelineColorBlendAttachmentState writes{};
        writes.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                                VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        const std::vector<VkPipelineColorBlendAttachmentState> blends(program.outputs, writes);
        VkPipelineColorBlendStateCreateInfo blend{};
        blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
        blend.attachmentCount = program.outputs;
        blend.pAttachments = blends.data();

        const std::array dynamicStates{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
        VkPipelineDynamicStateCreateInfo dynamic{};
        dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
        dynamic.dynamicStateCount = std::uint32_t(dynamicStates.size());
        dynamic.pDynamicStates = dynamicStates.data();

        const std::vector<VkFormat> formats(program.outputs, VK_FORMAT_R16G16B16A16_SFLOAT);
        VkPipelineRenderingCreateInfo targets{};
        targets.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
        targets.colorAttachmentCount = program.outputs;
        targets.pColorAttachmentFormats = formats.data();
        targets.depthAttachmentFormat = VK_FORMAT_D32_SFLOAT;

        VkGraphicsPipelineCreateInfo wanted{};
        wanted.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
        wanted.pNext = &targets;
        wanted.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
        if (hasListings) {
            wanted.flags |= VK_PIPELINE_CREATE_CAPTURE_INTERNAL_REPRESENTATIONS_BIT_KHR;
        }
        wanted.stageCount = std::uint32_t(stages.size());
        wanted.pStages = stages.data();
        wanted.pVertexInputState = &input;
        wanted.pInputAssemblyState = &assembly;
        wanted.pViewportState = &viewport;
        wanted.pRasterizationState = &raster;
        wanted.pMultisampleState = &samples;
        wanted.pDepthStencilState = &depth;
        wanted.pColorBlendState = &blend;
        wanted.pDynamicState = &dynamic;
        wanted.layout = layout;
        VkPipeline made = VK_NULL_HANDLE;
        const VkResult result =
            vkCreateGraphicsPipelines(device_.handle, VK_NULL_HANDLE, 1, &wanted, nullptr, &made);
        return owned(result, made, vkDestroyPipeline, "the program");
    }

    StageStatistics statisticsOf(VkPipeline pipeline, bool hasListings) const {
        const VkPipelineInfoKHR asked{VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, nullptr, pipeline};
        const auto executables =
            listed(device_.handle, asked, VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR,
                   executables_);
        StageStatistics all;
        for (std::size_t i = 0; i < executables.size(); ++i) {
            const VkPipelineExecutableInfoKHR one{VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR,
                                                  nullptr, pipeline, std::uint32_t(i)};
            Statistics& numbers = all[stageName(executables[i].stages)];
            numbers = executableStatistics(one);
            numbers["Subgroup size"] = executables[i].subgroupSize;
            const std::string listing = hasListings ? listingOf(one) : std::string();
            numbers["Loops"] = occurrences(listing, "loop-header");
            numbers["Look-ups"] = lookUpsIn(listing);
            // RADV counts the smallest waves, of which a larger one takes the room of several.
            numbers["Subgroups per SIMD"] *= double(smallestWave_) / executables[i].subgroupSize;
        }
        return all;
    }

    Statistics executableStatistics(const VkPipelineExecutableInfoKHR& executable) const {
        Statistics numbers;
        for (const VkPipelineExecutableStatisticKHR& statistic :
             listed(device_.handle, executable, VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR,
                    statistics_)) {
            numbers[statistic.name] = numberIn(statistic);
        }
        return numbers;
    }

    /// Returns the driver's listing of a stage's code; empty where it gives none.
    std::string listingOf(const VkPipelineExecutableInfoKHR& executable) const {
        auto listings =
            listed(device_.handle, executable,
                   VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INTERNAL_REPRESENTATION_KHR, listings_);
        std::vector<std::string> texts;
        for (VkPipelineExecutableInternalRepresentationKHR& listing : listings) {
            texts.emplace_back(listing.dataSize, '\0');
            listing.pData = texts.back().data();
        }
        auto count = std::uint32_t(listings.size());
        listings_(device_.handle, &executable, &count, listings.data());
        for (std::size_t i = 0; i < listings.size(); ++i) {
            if (std::string_view(listings[i].name) == "ACO IR") {
                return texts[i];
            }
        }
        return {};
    }

    Instance instance_;
    Device device_;
    std::string driver_;
    std::uint32_t smallestWave_; ///< lanes
    PFN_vkGetPipelineExecutablePropertiesKHR executables_;
    PFN_vkGetPipelineExecutableStatisticsKHR statistics_;
    PFN_vkGetPipelineExecutableInternalRepresentationsKHR listings_;
};

NullDevice::NullDevice(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
NullDevice::NullDevice(NullDevice&&) noexcept = default;
NullDevice& NullDevice::operator=(NullDevice&&) noexcept = default;
NullDevice::~NullDevice() = default;

Result<NullDevice> NullDevice::create(std::span<const std::string> chips) {
    const fs::path manifest = driverManifest();
    if (manifest.empty()) {
        return failure("there is no RADV, Mesa's Vulkan driver for AMD's cards",
                       "the package mesa-vulkan-drivers, installed");
    }
    // Only this driver is loaded; its cache on the disk would hold nothing that is asked for.
    ::setenv("VK_ICD_FILENAMES", manifest.c_str(), 1);
    ::setenv("VK_DRIVER_FILES", manifest.c_str(), 1);
    ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    ChipAnswer answer = ChipAnswer::Unknown;
    const auto chip = std::ranges::find_if(chips, [&answer](const std::string& each) {
        answer = answerAbout(each);
        return answer != ChipAnswer::Unknown;
    });
    if (answer == ChipAnswer::NoDriver) {
        return failure("\"" + manifest.string() + "\" names no Vulkan driver that can be loaded",
                       "that of the package mesa-vulkan-drivers, radeon_icd");
    }
    if (chip == chips.end()) {
        return failure("this Vulkan driver does not know the chip " +
                           (chips.empty() ? std::string() : chips.back()),
                       "a newer mesa-vulkan-drivers");
    }
    ::setenv(chipVariable, chip->c_str(), 1);
    auto instance = makeInstance();
    if (!instance) {
        return tl::unexpected(instance.error());
    }
    const VkPhysicalDevice physical = firstDevice(*instance);
    if (physical == VK_NULL_HANDLE) {
        return failure("the Vulkan driver has no device for the chip " + *chip);
    }
    auto device = makeDevice(physical);
    if (!device) {
        return tl::unexpected(device.error());
    }
    return NullDevice(
        std::make_unique<Implementation>(std::move(*instance), physical, std::move(*device)));
}

const std::string& NullDevice::driver() const {
    return implementation_->driver();
}

Result<NullDevice::StageStatistics> NullDevice::compile(const SpirvProgram& program,
                                                        bool countsLoops) const {
    return implementation_->compile(program, countsLoops);
}

} // namespace patina
