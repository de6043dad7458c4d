struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_13 {
member: array<f32>,
}
struct type_17 {
member: u32,
member_1: u32,
}
struct type_18 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
member_14: f32,
member_15: f32,
member_16: f32,
}
struct type_20 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_21 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_22 {
member: type_5,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_23 {
member: type_2,
member_1: type_17,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_18,
member_12: type_19,
member_13: type_20,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_21,
member_19: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
}
struct type_27 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: f32,
member_5: bool,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_24;
@group(0) @binding(1)
var<storage> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_13;
@group(0) @binding(3)
var<storage> global_4: type_13;
@group(0) @binding(7)
var<storage, read_write> global_5: type_13;
@group(0) @binding(4)
var<storage> global_6: type_13;
@group(0) @binding(5)
var<storage> global_7: type_13;
@group(0) @binding(6)
var<storage> global_8: type_13;
fn function_() {
var local: f32;
var local_1: i32;
var local_2: f32;
var local_3: i32;
var local_4: f32;
var local_5: i32;
var local_6: f32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: u32;
var local_12: u32;
var local_13: u32;
var local_14: u32;
var local_15: type_17;
var local_16: u32;
var local_17: u32;
var local_18: type_17;
var local_19: u32;
var local_20: type_25;
var local_21: i32;
var local_22: i32;
var phi_2480_: type_27;
var phi_2544_: bool;
var phi_2576_: f32;
var phi_2656_: u32;
var phi_2657_: u32;
var phi_2669_: u32;
var phi_2670_: u32;
var local_23: u32;
var local_24: u32;
var phi_2687_: u32;
var phi_2688_: u32;
var phi_2700_: u32;
var phi_2701_: u32;
var local_25: u32;
var local_26: u32;
var local_27: u32;
var phi_2726_: u32;
var phi_2727_: u32;
var local_28: u32;
var local_29: u32;
var phi_2744_: u32;
var phi_2745_: u32;
var local_30: u32;
var local_31: u32;
var phi_2767_: u32;
var phi_2768_: u32;
var phi_2780_: u32;
var phi_2781_: u32;
var local_32: u32;
var local_33: u32;
var local_34: u32;
var phi_2817_: u32;
var local_35: u32;
var phi_2830_: vec3<f32>;
var phi_2833_: type_17;
var phi_3092_: u32;
var phi_3123_: u32;
var phi_3147_: u32;
var phi_3183_: u32;
var phi_3254_: u32;
var phi_3344_: u32;
var phi_3148_: u32;
var phi_3395_: u32;
var phi_3397_: vec3<f32>;
var phi_3400_: u32;
var phi_3429_: u32;
var phi_3475_: i32;
var phi_5354_: f32;
var phi_5355_: f32;
var phi_5378_: u32;
var phi_5381_: f32;
var phi_5516_: i32;
var phi_5529_: i32;
var phi_5543_: i32;
var phi_5859_: i32;
var phi_5872_: i32;
var phi_5886_: i32;
var phi_5379_: u32;
var phi_5382_: f32;
var phi_6091_: f32;
var phi_6424_: vec3<f32>;
var phi_6425_: vec3<f32>;
var phi_6426_: bool;
var phi_6430_: vec3<f32>;
var phi_6431_: bool;
var phi_6447_: vec3<f32>;
var phi_3398_: vec3<f32>;
var phi_3401_: u32;
var phi_6457_: type_17;
var phi_6458_: type_17;
var phi_6479_: vec3<f32>;
var phi_6480_: type_17;
var phi_2831_: vec3<f32>;
var phi_2834_: type_17;
var phi_6628_: u32;
var phi_6631_: f32;
var phi_6766_: i32;
var phi_6779_: i32;
var phi_6793_: i32;
var phi_7109_: i32;
var phi_7122_: i32;
var phi_7136_: i32;
var phi_6629_: u32;
var phi_6632_: f32;
var phi_7341_: f32;
var local_36: vec3<f32>;
var local_37: vec3<f32>;
var local_38: vec3<f32>;
var phi_7580_: array<f32, 22>;
var local_39: u32;
var local_40: f32;
var local_41: vec3<f32>;
var local_42: type_17;
var local_43: f32;
let _e133 = global;
let _e142 = arrayLength((&global_4.member));
let _e144 = arrayLength((&global_6.member));
let _e154 = global_1.member.member;
if (_e133.x < _e154.member) {
if (_e133.y < _e154.member_1) {
let _e161 = (_e154.member * _e154.member_1);
let _e163 = ((_e133.y * _e154.member) + _e133.x);
let _e164 = bitcast<i32>(_e163);
let _e166 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e168 = select(_e166, _e164, (_e164 < _e166));
let _e174 = global_5.member[bitcast<u32>(select(0i, _e168, (_e168 > 0i)))];
let _e175 = (_e161 + _e163);
let _e176 = bitcast<i32>(_e175);
let _e178 = select(_e166, _e176, (_e176 < _e166));
let _e184 = global_5.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = ((2u * _e161) + _e163);
let _e187 = bitcast<i32>(_e186);
let _e189 = select(_e166, _e187, (_e187 < _e166));
let _e195 = global_5.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = ((3u * _e161) + _e163);
let _e198 = bitcast<i32>(_e197);
let _e200 = select(_e166, _e198, (_e198 < _e166));
let _e206 = global_5.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e208 = ((4u * _e161) + _e163);
let _e209 = bitcast<i32>(_e208);
let _e211 = select(_e166, _e209, (_e209 < _e166));
let _e217 = global_5.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e219 = ((5u * _e161) + _e163);
let _e220 = bitcast<i32>(_e219);
let _e222 = select(_e166, _e220, (_e220 < _e166));
let _e228 = global_5.member[bitcast<u32>(select(0i, _e222, (_e222 > 0i)))];
let _e230 = ((6u * _e161) + _e163);
let _e231 = bitcast<i32>(_e230);
let _e233 = select(_e166, _e231, (_e231 < _e166));
let _e239 = global_5.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e241 = ((7u * _e161) + _e163);
let _e242 = bitcast<i32>(_e241);
let _e244 = select(_e166, _e242, (_e242 < _e166));
let _e250 = global_5.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e252 = ((8u * _e161) + _e163);
let _e253 = bitcast<i32>(_e252);
let _e255 = select(_e166, _e253, (_e253 < _e166));
let _e261 = global_5.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e263 = ((9u * _e161) + _e163);
let _e264 = bitcast<i32>(_e263);
let _e266 = select(_e166, _e264, (_e264 < _e166));
let _e272 = global_5.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e274 = ((10u * _e161) + _e163);
let _e275 = bitcast<i32>(_e274);
let _e277 = select(_e166, _e275, (_e275 < _e166));
let _e283 = global_5.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e285 = ((11u * _e161) + _e163);
let _e286 = bitcast<i32>(_e285);
let _e288 = select(_e166, _e286, (_e286 < _e166));
let _e294 = global_5.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e296 = ((12u * _e161) + _e163);
let _e297 = bitcast<i32>(_e296);
let _e299 = select(_e166, _e297, (_e297 < _e166));
let _e305 = global_5.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e307 = ((13u * _e161) + _e163);
let _e308 = bitcast<i32>(_e307);
let _e310 = select(_e166, _e308, (_e308 < _e166));
let _e316 = global_5.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e318 = ((14u * _e161) + _e163);
let _e319 = bitcast<i32>(_e318);
let _e321 = select(_e166, _e319, (_e319 < _e166));
let _e327 = global_5.member[bitcast<u32>(select(0i, _e321, (_e321 > 0i)))];
let _e329 = ((15u * _e161) + _e163);
let _e330 = bitcast<i32>(_e329);
let _e332 = select(_e166, _e330, (_e330 < _e166));
let _e338 = global_5.member[bitcast<u32>(select(0i, _e332, (_e332 > 0i)))];
let _e340 = ((16u * _e161) + _e163);
let _e341 = bitcast<i32>(_e340);
let _e343 = select(_e166, _e341, (_e341 < _e166));
let _e349 = global_5.member[bitcast<u32>(select(0i, _e343, (_e343 > 0i)))];
let _e351 = ((17u * _e161) + _e163);
let _e352 = bitcast<i32>(_e351);
let _e354 = select(_e166, _e352, (_e352 < _e166));
let _e360 = global_5.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e362 = ((18u * _e161) + _e163);
let _e363 = bitcast<i32>(_e362);
let _e365 = select(_e166, _e363, (_e363 < _e166));
let _e371 = global_5.member[bitcast<u32>(select(0i, _e365, (_e365 > 0i)))];
let _e373 = ((19u * _e161) + _e163);
let _e374 = bitcast<i32>(_e373);
let _e376 = select(_e166, _e374, (_e374 < _e166));
let _e382 = global_5.member[bitcast<u32>(select(0i, _e376, (_e376 > 0i)))];
let _e384 = ((20u * _e161) + _e163);
let _e385 = bitcast<i32>(_e384);
let _e387 = select(_e166, _e385, (_e385 < _e166));
let _e393 = global_5.member[bitcast<u32>(select(0i, _e387, (_e387 > 0i)))];
let _e395 = ((21u * _e161) + _e163);
let _e396 = bitcast<i32>(_e395);
let _e398 = select(_e166, _e396, (_e396 < _e166));
let _e404 = global_5.member[bitcast<u32>(select(0i, _e398, (_e398 > 0i)))];
let _e409 = global_1.member.member.member;
let _e413 = global_1.member.member.member_1;
let _e414 = (_e409 * _e413);
local_21 = bitcast<i32>(_e414);
let _e417 = ((_e133.y * _e409) + _e133.x);
let _e418 = bitcast<i32>(_e417);
local_22 = _e418;
let _e419 = local_21;
let _e421 = local_22;
let _e422 = ((29i * _e419) + _e421);
let _e424 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e426 = select(_e424, _e422, (_e422 < _e424));
let _e431 = global_2.member[bitcast<u32>(select(0i, _e426, (_e426 > 0i)))];
let _e433 = local_21;
let _e435 = local_22;
let _e436 = ((36i * _e433) + _e435);
let _e438 = select(_e424, _e436, (_e436 < _e424));
let _e443 = global_2.member[bitcast<u32>(select(0i, _e438, (_e438 > 0i)))];
let _e454 = global_1.member.member_12.member_4;
if (select(0u, 3u, ((_e431 == 2f) && (select(0i, select(select(i32(_e443), i32(-2147483648), (_e443 < -2147483600f)), 2147483647i, (_e443 > 2147483500f)), (_e443 == _e443)) == (bitcast<i32>(_e454) + 1i)))) > 1u) {
let _e462 = select(_e424, _e418, (_e418 < _e424));
let _e468 = global_2.member[bitcast<u32>(select(0i, _e462, (_e462 > 0i)))];
let _e470 = bitcast<i32>((_e414 + _e417));
let _e472 = select(_e424, _e470, (_e470 < _e424));
let _e478 = global_2.member[bitcast<u32>(select(0i, _e472, (_e472 > 0i)))];
let _e481 = bitcast<i32>(((2u * _e414) + _e417));
let _e483 = select(_e424, _e481, (_e481 < _e424));
let _e489 = global_2.member[bitcast<u32>(select(0i, _e483, (_e483 > 0i)))];
let _e492 = bitcast<i32>(((3u * _e414) + _e417));
let _e494 = select(_e424, _e492, (_e492 < _e424));
let _e500 = global_2.member[bitcast<u32>(select(0i, _e494, (_e494 > 0i)))];
let _e503 = bitcast<i32>(((4u * _e414) + _e417));
let _e505 = select(_e424, _e503, (_e503 < _e424));
let _e511 = global_2.member[bitcast<u32>(select(0i, _e505, (_e505 > 0i)))];
let _e514 = bitcast<i32>(((5u * _e414) + _e417));
let _e516 = select(_e424, _e514, (_e514 < _e424));
let _e522 = global_2.member[bitcast<u32>(select(0i, _e516, (_e516 > 0i)))];
let _e525 = bitcast<i32>(((6u * _e414) + _e417));
let _e527 = select(_e424, _e525, (_e525 < _e424));
let _e533 = global_2.member[bitcast<u32>(select(0i, _e527, (_e527 > 0i)))];
let _e536 = bitcast<i32>(((7u * _e414) + _e417));
let _e538 = select(_e424, _e536, (_e536 < _e424));
let _e544 = global_2.member[bitcast<u32>(select(0i, _e538, (_e538 > 0i)))];
let _e547 = bitcast<i32>(((8u * _e414) + _e417));
let _e549 = select(_e424, _e547, (_e547 < _e424));
let _e555 = global_2.member[bitcast<u32>(select(0i, _e549, (_e549 > 0i)))];
let _e558 = bitcast<i32>(((9u * _e414) + _e417));
let _e560 = select(_e424, _e558, (_e558 < _e424));
let _e566 = global_2.member[bitcast<u32>(select(0i, _e560, (_e560 > 0i)))];
let _e569 = bitcast<i32>(((10u * _e414) + _e417));
let _e571 = select(_e424, _e569, (_e569 < _e424));
let _e577 = global_2.member[bitcast<u32>(select(0i, _e571, (_e571 > 0i)))];
let _e580 = bitcast<i32>(((11u * _e414) + _e417));
let _e582 = select(_e424, _e580, (_e580 < _e424));
let _e588 = global_2.member[bitcast<u32>(select(0i, _e582, (_e582 > 0i)))];
let _e591 = bitcast<i32>(((12u * _e414) + _e417));
let _e593 = select(_e424, _e591, (_e591 < _e424));
let _e599 = global_2.member[bitcast<u32>(select(0i, _e593, (_e593 > 0i)))];
let _e602 = bitcast<i32>(((13u * _e414) + _e417));
let _e604 = select(_e424, _e602, (_e602 < _e424));
let _e610 = global_2.member[bitcast<u32>(select(0i, _e604, (_e604 > 0i)))];
let _e613 = bitcast<i32>(((14u * _e414) + _e417));
let _e615 = select(_e424, _e613, (_e613 < _e424));
let _e621 = global_2.member[bitcast<u32>(select(0i, _e615, (_e615 > 0i)))];
let _e624 = bitcast<i32>(((15u * _e414) + _e417));
let _e626 = select(_e424, _e624, (_e624 < _e424));
let _e632 = global_2.member[bitcast<u32>(select(0i, _e626, (_e626 > 0i)))];
let _e635 = bitcast<i32>(((16u * _e414) + _e417));
let _e637 = select(_e424, _e635, (_e635 < _e424));
let _e643 = global_2.member[bitcast<u32>(select(0i, _e637, (_e637 > 0i)))];
let _e646 = bitcast<i32>(((17u * _e414) + _e417));
let _e648 = select(_e424, _e646, (_e646 < _e424));
let _e654 = global_2.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e657 = bitcast<i32>(((18u * _e414) + _e417));
let _e659 = select(_e424, _e657, (_e657 < _e424));
let _e665 = global_2.member[bitcast<u32>(select(0i, _e659, (_e659 > 0i)))];
let _e668 = bitcast<i32>(((19u * _e414) + _e417));
let _e670 = select(_e424, _e668, (_e668 < _e424));
let _e676 = global_2.member[bitcast<u32>(select(0i, _e670, (_e670 > 0i)))];
let _e679 = bitcast<i32>(((20u * _e414) + _e417));
let _e681 = select(_e424, _e679, (_e679 < _e424));
let _e687 = global_2.member[bitcast<u32>(select(0i, _e681, (_e681 > 0i)))];
let _e690 = bitcast<i32>(((23u * _e414) + _e417));
let _e692 = select(_e424, _e690, (_e690 < _e424));
let _e698 = global_2.member[bitcast<u32>(select(0i, _e692, (_e692 > 0i)))];
let _e701 = bitcast<i32>(((24u * _e414) + _e417));
let _e703 = select(_e424, _e701, (_e701 < _e424));
let _e709 = global_2.member[bitcast<u32>(select(0i, _e703, (_e703 > 0i)))];
let _e712 = bitcast<i32>(((30u * _e414) + _e417));
let _e714 = select(_e424, _e712, (_e712 < _e424));
let _e720 = global_2.member[bitcast<u32>(select(0i, _e714, (_e714 > 0i)))];
let _e727 = select(0i, select(select(i32(_e698), i32(-2147483648), (_e698 < -2147483600f)), 2147483647i, (_e698 > 2147483500f)), (_e698 == _e698));
let _e735 = (select(0i, select(select(i32(_e720), i32(-2147483648), (_e720 < -2147483600f)), 2147483647i, (_e720 > 2147483500f)), (_e720 == _e720)) == 0i);
let _e743 = global_1.member.member_1.member;
let _e749 = global_1.member.member_1.member_1;
let _e759 = global_1.member.member_2.member;
let _e760 = (((((f32(bitcast<i32>(_e133.x)) + 0.5f) / f32(bitcast<i32>(_e743))) * 2f) - 1f) * _e759);
let _e768 = global_1.member.member_2.member_1;
let _e769 = ((1f - (((f32(bitcast<i32>(_e133.y)) + 0.5f) / f32(bitcast<i32>(_e749))) * 2f)) * _e768);
let _e772 = global_1.member.member_3;
let _e781 = global_1.member.member_4;
let _e794 = global_1.member.member_2.member_3;
let _e795 = (_e794 != 0u);
let _e798 = global_1.member.member_6;
let _e805 = select(_e798.member, (_e798.member + ((_e772.member * _e760) + (_e781.member * _e769))), _e795);
let _e806 = select(_e798.member_1, (_e798.member_1 + ((_e772.member_1 * _e760) + (_e781.member_1 * _e769))), _e795);
let _e807 = select(_e798.member_2, (_e798.member_2 + ((_e772.member_2 * _e760) + (_e781.member_2 * _e769))), _e795);
let _e817 = select(_e468, _e805, _e735);
let _e818 = select(_e478, _e806, _e735);
let _e819 = select(_e489, _e807, _e735);
let _e820 = (select(0f, ((((_e468 - _e805) * _e500) + ((_e478 - _e806) * _e511)) + ((_e489 - _e807) * _e522)), _e735) + _e709);
let _e825 = select(_e820, 0f, (_e727 == -1i));
let _e829 = (_e817 + (_e500 * _e825));
let _e830 = (_e818 + (_e511 * _e825));
let _e831 = (_e819 + (_e522 * _e825));
let _e832 = vec3<f32>(_e829, _e830, _e831);
let _e835 = global_1.member.member_17;
let _e838 = (_e727 >= 0i);
if _e838 {
let _e883 = (_e727 * 19i);
let _e885 = (bitcast<i32>(_e144) - 1i);
let _e887 = select(_e885, _e883, (_e883 < _e885));
let _e893 = global_6.member[bitcast<u32>(select(0i, _e887, (_e887 > 0i)))];
let _e894 = (_e883 + 1i);
let _e896 = select(_e885, _e894, (_e894 < _e885));
let _e902 = global_6.member[bitcast<u32>(select(0i, _e896, (_e896 > 0i)))];
let _e903 = (_e883 + 2i);
let _e905 = select(_e885, _e903, (_e903 < _e885));
let _e911 = global_6.member[bitcast<u32>(select(0i, _e905, (_e905 > 0i)))];
let _e912 = (_e883 + 3i);
let _e914 = select(_e885, _e912, (_e912 < _e885));
let _e920 = global_6.member[bitcast<u32>(select(0i, _e914, (_e914 > 0i)))];
let _e921 = (_e883 + 4i);
let _e923 = select(_e885, _e921, (_e921 < _e885));
let _e929 = global_6.member[bitcast<u32>(select(0i, _e923, (_e923 > 0i)))];
let _e930 = (_e883 + 5i);
let _e932 = select(_e885, _e930, (_e930 < _e885));
let _e938 = global_6.member[bitcast<u32>(select(0i, _e932, (_e932 > 0i)))];
let _e939 = (_e883 + 6i);
let _e941 = select(_e885, _e939, (_e939 < _e885));
let _e947 = global_6.member[bitcast<u32>(select(0i, _e941, (_e941 > 0i)))];
let _e948 = (_e883 + 7i);
let _e950 = select(_e885, _e948, (_e948 < _e885));
let _e956 = global_6.member[bitcast<u32>(select(0i, _e950, (_e950 > 0i)))];
let _e957 = (_e883 + 8i);
let _e959 = select(_e885, _e957, (_e957 < _e885));
let _e965 = global_6.member[bitcast<u32>(select(0i, _e959, (_e959 > 0i)))];
let _e966 = (_e920 - _e893);
let _e967 = (_e929 - _e902);
let _e968 = (_e938 - _e911);
let _e969 = (_e947 - _e893);
let _e970 = (_e956 - _e902);
let _e971 = (_e965 - _e911);
let _e974 = ((_e967 * _e971) - (_e968 * _e970));
let _e977 = ((_e968 * _e969) - (_e966 * _e971));
let _e980 = ((_e966 * _e970) - (_e967 * _e969));
let _e981 = (_e920 - _e829);
let _e982 = (_e929 - _e830);
let _e983 = (_e938 - _e831);
let _e984 = (_e947 - _e829);
let _e985 = (_e956 - _e830);
let _e986 = (_e965 - _e831);
let _e1000 = (((((_e982 * _e986) - (_e983 * _e985)) * _e974) + (((_e983 * _e984) - (_e981 * _e986)) * _e977)) + (((_e981 * _e985) - (_e982 * _e984)) * _e980));
let _e1002 = select(0f, _e1000, (_e1000 > 0f));
let _e1003 = (_e893 - _e829);
let _e1004 = (_e902 - _e830);
let _e1005 = (_e911 - _e831);
let _e1019 = (((((_e985 * _e1005) - (_e986 * _e1004)) * _e974) + (((_e986 * _e1003) - (_e984 * _e1005)) * _e977)) + (((_e984 * _e1004) - (_e985 * _e1003)) * _e980));
let _e1021 = select(0f, _e1019, (_e1019 > 0f));
let _e1035 = (((((_e1004 * _e983) - (_e1005 * _e982)) * _e974) + (((_e1005 * _e981) - (_e1003 * _e983)) * _e977)) + (((_e1003 * _e982) - (_e1004 * _e981)) * _e980));
let _e1037 = select(0f, _e1035, (_e1035 > 0f));
let _e1039 = ((_e1002 + _e1021) + _e1037);
let _e1041 = select(1e-30f, _e1039, (_e1039 > 1e-30f));
let _e1042 = (_e1002 / _e1041);
let _e1043 = (_e1021 / _e1041);
let _e1044 = (_e1037 / _e1041);
let _e1049 = (((_e974 * _e974) + (_e977 * _e977)) + (_e980 * _e980));
let _e1052 = sqrt(select(0f, _e1049, (_e1049 > 0f)));
let _e1055 = (1f / select(1e-20f, _e1052, (_e1052 > 1e-20f)));
let _e1060 = (_e883 + 9i);
let _e1062 = select(_e885, _e1060, (_e1060 < _e885));
let _e1068 = global_6.member[bitcast<u32>(select(0i, _e1062, (_e1062 > 0i)))];
let _e1069 = (_e883 + 10i);
let _e1071 = select(_e885, _e1069, (_e1069 < _e885));
let _e1077 = global_6.member[bitcast<u32>(select(0i, _e1071, (_e1071 > 0i)))];
let _e1078 = (_e883 + 11i);
let _e1080 = select(_e885, _e1078, (_e1078 < _e885));
let _e1086 = global_6.member[bitcast<u32>(select(0i, _e1080, (_e1080 > 0i)))];
let _e1090 = (_e883 + 12i);
let _e1092 = select(_e885, _e1090, (_e1090 < _e885));
let _e1098 = global_6.member[bitcast<u32>(select(0i, _e1092, (_e1092 > 0i)))];
let _e1099 = (_e883 + 13i);
let _e1101 = select(_e885, _e1099, (_e1099 < _e885));
let _e1107 = global_6.member[bitcast<u32>(select(0i, _e1101, (_e1101 > 0i)))];
let _e1108 = (_e883 + 14i);
let _e1110 = select(_e885, _e1108, (_e1108 < _e885));
let _e1116 = global_6.member[bitcast<u32>(select(0i, _e1110, (_e1110 > 0i)))];
let _e1123 = (_e883 + 15i);
let _e1125 = select(_e885, _e1123, (_e1123 < _e885));
let _e1131 = global_6.member[bitcast<u32>(select(0i, _e1125, (_e1125 > 0i)))];
let _e1132 = (_e883 + 16i);
let _e1134 = select(_e885, _e1132, (_e1132 < _e885));
let _e1140 = global_6.member[bitcast<u32>(select(0i, _e1134, (_e1134 > 0i)))];
let _e1141 = (_e883 + 17i);
let _e1143 = select(_e885, _e1141, (_e1141 < _e885));
let _e1149 = global_6.member[bitcast<u32>(select(0i, _e1143, (_e1143 > 0i)))];
let _e1153 = (((_e1068 * _e1042) + (_e1098 * _e1043)) + (_e1131 * _e1044));
let _e1154 = (((_e1077 * _e1042) + (_e1107 * _e1043)) + (_e1140 * _e1044));
let _e1155 = (((_e1086 * _e1042) + (_e1116 * _e1043)) + (_e1149 * _e1044));
let _e1160 = (((_e1153 * _e1153) + (_e1154 * _e1154)) + (_e1155 * _e1155));
let _e1163 = sqrt(select(0f, _e1160, (_e1160 > 0f)));
let _e1166 = (1f / select(1e-20f, _e1163, (_e1163 > 1e-20f)));
let _e1171 = (_e883 + 18i);
let _e1173 = select(_e885, _e1171, (_e1171 < _e885));
let _e1179 = global_6.member[bitcast<u32>(select(0i, _e1173, (_e1173 > 0i)))];
let _e1188 = (select(select(0i, select(select(i32(_e1179), i32(-2147483648), (_e1179 < -2147483600f)), 2147483647i, (_e1179 > 2147483500f)), (_e1179 == _e1179)), _e727, ((_e835 & 1u) != 0u)) * 10i);
let _e1190 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1192 = select(_e1190, _e1188, (_e1188 < _e1190));
let _e1198 = global_7.member[bitcast<u32>(select(0i, _e1192, (_e1192 > 0i)))];
let _e1199 = (_e1188 + 1i);
let _e1201 = select(_e1190, _e1199, (_e1199 < _e1190));
let _e1207 = global_7.member[bitcast<u32>(select(0i, _e1201, (_e1201 > 0i)))];
let _e1208 = (_e1188 + 2i);
let _e1210 = select(_e1190, _e1208, (_e1208 < _e1190));
let _e1216 = global_7.member[bitcast<u32>(select(0i, _e1210, (_e1210 > 0i)))];
let _e1220 = (_e1188 + 3i);
let _e1222 = select(_e1190, _e1220, (_e1220 < _e1190));
let _e1228 = global_7.member[bitcast<u32>(select(0i, _e1222, (_e1222 > 0i)))];
let _e1229 = (_e1188 + 4i);
let _e1231 = select(_e1190, _e1229, (_e1229 < _e1190));
let _e1237 = global_7.member[bitcast<u32>(select(0i, _e1231, (_e1231 > 0i)))];
let _e1238 = (_e1188 + 5i);
let _e1240 = select(_e1190, _e1238, (_e1238 < _e1190));
let _e1246 = global_7.member[bitcast<u32>(select(0i, _e1240, (_e1240 > 0i)))];
let _e1253 = (_e1188 + 6i);
let _e1255 = select(_e1190, _e1253, (_e1253 < _e1190));
let _e1261 = global_7.member[bitcast<u32>(select(0i, _e1255, (_e1255 > 0i)))];
let _e1262 = (_e1188 + 7i);
let _e1264 = select(_e1190, _e1262, (_e1262 < _e1190));
let _e1270 = global_7.member[bitcast<u32>(select(0i, _e1264, (_e1264 > 0i)))];
let _e1271 = (_e1188 + 8i);
let _e1273 = select(_e1190, _e1271, (_e1271 < _e1190));
let _e1279 = global_7.member[bitcast<u32>(select(0i, _e1273, (_e1273 > 0i)))];
let _e1287 = (_e1188 + 9i);
let _e1289 = select(_e1190, _e1287, (_e1287 < _e1190));
let _e1295 = global_7.member[bitcast<u32>(select(0i, _e1289, (_e1289 > 0i)))];
phi_2480_ = type_27(_e832, vec3<f32>((_e974 * _e1055), (_e977 * _e1055), (_e980 * _e1055)), vec3<f32>((_e1153 * _e1166), (_e1154 * _e1166), (_e1155 * _e1166)), vec3<f32>((((_e1198 * _e1042) + (_e1228 * _e1043)) + (_e1261 * _e1044)), (((_e1207 * _e1042) + (_e1237 * _e1043)) + (_e1270 * _e1044)), (((_e1216 * _e1042) + (_e1246 * _e1043)) + (_e1279 * _e1044))), _e1295, true);
} else {
let _e839 = (_e727 == -3i);
let _e845 = global_1.member.member_14.member_1.member.member;
let _e850 = global_1.member.member_14.member_1.member_1;
let _e856 = global_1.member.member_14.member.member.member;
let _e861 = global_1.member.member_14.member.member_1;
let _e871 = vec3<f32>(select(_e856.member, _e845.member, _e839), select(_e856.member_1, _e845.member_1, _e839), select(_e856.member_2, _e845.member_2, _e839));
phi_2480_ = type_27(_e832, _e871, _e871, vec3<f32>(select(_e861.member, _e850.member, _e839), select(_e861.member_1, _e850.member_1, _e839), select(_e861.member_2, _e850.member_2, _e839)), 0f, false);
}
let _e1298 = phi_2480_;
let _e1301 = ((select(0i, _e727, _e838) * 19i) + 18i);
let _e1303 = (bitcast<i32>(_e144) - 1i);
let _e1305 = select(_e1303, _e1301, (_e1301 < _e1303));
let _e1311 = global_6.member[bitcast<u32>(select(0i, _e1305, (_e1305 > 0i)))];
let _e1318 = select(0i, select(select(i32(_e1311), i32(-2147483648), (_e1311 < -2147483600f)), 2147483647i, (_e1311 > 2147483500f)), (_e1311 == _e1311));
let _e1319 = (_e1318 * 4i);
let _e1321 = (bitcast<i32>(arrayLength((&global_8.member))) - 1i);
let _e1323 = select(_e1321, _e1319, (_e1319 < _e1321));
let _e1329 = global_8.member[bitcast<u32>(select(0i, _e1323, (_e1323 > 0i)))];
if _e838 {
phi_2544_ = (select(_e1329, 1f, (_e1318 == 16i)) == 0f);
} else {
phi_2544_ = (_e727 != -1i);
}
let _e1335 = phi_2544_;
if _e1335 {
let _e1339 = (_e533 + (_e599 * _e709));
let _e1340 = (_e544 + (_e610 * _e709));
let _e1341 = (_e555 + (_e621 * _e709));
let _e1345 = (_e566 + (_e632 * _e709));
let _e1346 = (_e577 + (_e643 * _e709));
let _e1347 = (_e588 + (_e654 * _e709));
let _e1356 = (((_e500 * _e1298.member_1.x) + (_e511 * _e1298.member_1.y)) + (_e522 * _e1298.member_1.z));
if ((_e1356 * _e1356) > 1e-12f) {
phi_2576_ = (1f / _e1356);
} else {
phi_2576_ = 0f;
}
let _e1361 = phi_2576_;
let _e1367 = ((((_e1339 * _e1298.member_1.x) + (_e1340 * _e1298.member_1.y)) + (_e1341 * _e1298.member_1.z)) * _e1361);
let _e1371 = (_e1339 - (_e500 * _e1367));
let _e1372 = (_e1340 - (_e511 * _e1367));
let _e1373 = (_e1341 - (_e522 * _e1367));
let _e1379 = ((((_e1345 * _e1298.member_1.x) + (_e1346 * _e1298.member_1.y)) + (_e1347 * _e1298.member_1.z)) * _e1361);
let _e1383 = (_e1345 - (_e500 * _e1379));
let _e1384 = (_e1346 - (_e511 * _e1379));
let _e1385 = (_e1347 - (_e522 * _e1379));
let _e1390 = (((_e1371 * _e1371) + (_e1372 * _e1372)) + (_e1373 * _e1373));
let _e1398 = (((_e1383 * _e1383) + (_e1384 * _e1384)) + (_e1385 * _e1385));
let _e1404 = (0.05f + (0.5f * (sqrt(select(0f, _e1390, (_e1390 > 0f))) + sqrt(select(0f, _e1398, (_e1398 > 0f))))));
let _e1408 = global_1.member.member_11.member;
let _e1414 = global_1.member.member_12.member_5;
let _e1418 = global_1.member.member_12.member_6;
phi_2656_ = 0u;
loop {
let _e1422 = phi_2656_;
local_35 = _e1422;
let _e1426 = ((1u << bitcast<u32>((_e1422 & 31u))) < _e1408);
if _e1426 {
phi_2657_ = (_e1422 + 1u);
} else {
phi_2657_ = u32();
}
let _e1429 = phi_2657_;
continue;
continuing {
phi_2656_ = _e1429;
break if !(_e1426);
}
}
phi_2669_ = 0u;
loop {
let _e1432 = phi_2669_;
local_23 = _e1432;
local_24 = _e1432;
let _e1436 = ((1u << bitcast<u32>((_e1432 & 31u))) < _e1408);
if _e1436 {
phi_2670_ = (_e1432 + 1u);
} else {
phi_2670_ = u32();
}
let _e1439 = phi_2670_;
continue;
continuing {
phi_2669_ = _e1439;
break if !(_e1436);
}
}
let _e1442 = local_23;
let _e1445 = local_24;
phi_2687_ = 0u;
loop {
let _e1448 = phi_2687_;
local_27 = _e1448;
let _e1452 = ((1u << bitcast<u32>((_e1448 & 31u))) < _e1408);
if _e1452 {
phi_2688_ = (_e1448 + 1u);
} else {
phi_2688_ = u32();
}
let _e1455 = phi_2688_;
continue;
continuing {
phi_2687_ = _e1455;
break if !(_e1452);
}
}
phi_2700_ = 0u;
loop {
let _e1458 = phi_2700_;
local_25 = _e1458;
local_26 = _e1458;
let _e1462 = ((1u << bitcast<u32>((_e1458 & 31u))) < _e1408);
if _e1462 {
phi_2701_ = (_e1458 + 1u);
} else {
phi_2701_ = u32();
}
let _e1465 = phi_2701_;
continue;
continuing {
phi_2700_ = _e1465;
break if !(_e1462);
}
}
let _e1468 = local_25;
let _e1471 = local_26;
let _e1474 = local_27;
let _e1483 = global_1.member.member_12.member_8;
phi_2726_ = 0u;
loop {
let _e1486 = phi_2726_;
local_28 = _e1486;
local_29 = _e1486;
let _e1490 = ((1u << bitcast<u32>((_e1486 & 31u))) < _e1408);
if _e1490 {
phi_2727_ = (_e1486 + 1u);
} else {
phi_2727_ = u32();
}
let _e1493 = phi_2727_;
continue;
continuing {
phi_2726_ = _e1493;
break if !(_e1490);
}
}
let _e1496 = local_28;
let _e1499 = local_29;
phi_2744_ = 0u;
loop {
let _e1502 = phi_2744_;
local_30 = _e1502;
local_31 = _e1502;
let _e1506 = ((1u << bitcast<u32>((_e1502 & 31u))) < _e1408);
if _e1506 {
phi_2745_ = (_e1502 + 1u);
} else {
phi_2745_ = u32();
}
let _e1509 = phi_2745_;
continue;
continuing {
phi_2744_ = _e1509;
break if !(_e1506);
}
}
let _e1512 = local_30;
let _e1518 = local_31;
phi_2767_ = 0u;
loop {
let _e1528 = phi_2767_;
local_34 = _e1528;
let _e1532 = ((1u << bitcast<u32>((_e1528 & 31u))) < _e1408);
if _e1532 {
phi_2768_ = (_e1528 + 1u);
} else {
phi_2768_ = u32();
}
let _e1535 = phi_2768_;
continue;
continuing {
phi_2767_ = _e1535;
break if !(_e1532);
}
}
phi_2780_ = 0u;
loop {
let _e1538 = phi_2780_;
local_32 = _e1538;
local_33 = _e1538;
let _e1542 = ((1u << bitcast<u32>((_e1538 & 31u))) < _e1408);
if _e1542 {
phi_2781_ = (_e1538 + 1u);
} else {
phi_2781_ = u32();
}
let _e1545 = phi_2781_;
continue;
continuing {
phi_2780_ = _e1545;
break if !(_e1542);
}
}
let _e1548 = local_32;
let _e1551 = local_33;
let _e1554 = local_34;
let _e1560 = (((((1u << bitcast<u32>(((2u * _e1512) & 31u))) - (1u << bitcast<u32>(((2u * (_e1518 - select(6u, _e1499, (_e1496 < 6u)))) & 31u)))) / 3u) * 4u) + (1u << bitcast<u32>(((2u * (_e1554 - select(6u, _e1551, (_e1548 < 6u)))) & 31u))));
let _e1561 = (_e1560 / 64u);
if ((_e1560 % 64u) > 0u) {
phi_2817_ = (_e1561 + 1u);
} else {
phi_2817_ = _e1561;
}
let _e1566 = phi_2817_;
let _e1569 = local_35;
local_20 = type_25(_e1569, select(6u, _e1445, (_e1442 < 6u)), (1u << bitcast<u32>(((2u * (_e1474 - select(6u, _e1471, (_e1468 < 6u)))) & 31u))), (_e1414 * _e1483), (_e1566 * 64u));
let _e1572 = local_20.member_1;
phi_2830_ = vec3<f32>(0f, 0f, 0f);
phi_2833_ = type_17(_e1572, 0u);
loop {
let _e1575 = phi_2830_;
let _e1577 = phi_2833_;
local_36 = _e1575;
local_37 = _e1575;
local_38 = _e1575;
let _e1580 = local_20.member_1;
let _e1583 = local_20.member_2;
let _e1585 = ((_e1577.member < _e1580) || (_e1577.member_1 < _e1583));
if _e1585 {
local_18.member = _e1577.member;
local_18.member_1 = _e1577.member_1;
let _e1589 = local_18.member;
let _e1590 = local_18.member_1;
let _e1592 = local_20.member;
let _e1607 = local_20.member_3;
let _e1609 = local_20.member_4;
local_19 = ((_e1607 + (18u * _e1609)) + (((((1u << bitcast<u32>(((2u * _e1592) & 31u))) - (1u << bitcast<u32>(((2u * (_e1592 - _e1589)) & 31u)))) / 3u) * 4u) + _e1590));
let _e1613 = local_19;
let _e1614 = bitcast<i32>(_e1613);
let _e1616 = (bitcast<i32>(_e142) - 1i);
let _e1618 = select(_e1616, _e1614, (_e1614 < _e1616));
let _e1623 = global_4.member[bitcast<u32>(select(0i, _e1618, (_e1618 > 0i)))];
let _e1624 = local_19;
let _e1625 = local_20.member_4;
let _e1627 = bitcast<i32>((_e1624 + _e1625));
let _e1629 = select(_e1616, _e1627, (_e1627 < _e1616));
let _e1634 = global_4.member[bitcast<u32>(select(0i, _e1629, (_e1629 > 0i)))];
let _e1635 = local_19;
let _e1636 = local_20.member_4;
let _e1639 = bitcast<i32>((_e1635 + (2u * _e1636)));
let _e1641 = select(_e1616, _e1639, (_e1639 < _e1616));
let _e1646 = global_4.member[bitcast<u32>(select(0i, _e1641, (_e1641 > 0i)))];
let _e1647 = local_18.member;
let _e1648 = local_18.member_1;
let _e1649 = local_20.member;
let _e1663 = local_20.member_3;
let _e1664 = local_20.member_4;
local_17 = ((_e1663 + (21u * _e1664)) + (((((1u << bitcast<u32>(((2u * _e1649) & 31u))) - (1u << bitcast<u32>(((2u * (_e1649 - _e1647)) & 31u)))) / 3u) * 4u) + _e1648));
let _e1668 = local_17;
let _e1669 = bitcast<i32>(_e1668);
let _e1671 = select(_e1616, _e1669, (_e1669 < _e1616));
let _e1676 = global_4.member[bitcast<u32>(select(0i, _e1671, (_e1671 > 0i)))];
let _e1677 = local_17;
let _e1678 = local_20.member_4;
let _e1680 = bitcast<i32>((_e1677 + _e1678));
let _e1682 = select(_e1616, _e1680, (_e1680 < _e1616));
let _e1687 = global_4.member[bitcast<u32>(select(0i, _e1682, (_e1682 > 0i)))];
let _e1688 = local_17;
let _e1689 = local_20.member_4;
let _e1692 = bitcast<i32>((_e1688 + (2u * _e1689)));
let _e1694 = select(_e1616, _e1692, (_e1692 < _e1616));
let _e1699 = global_4.member[bitcast<u32>(select(0i, _e1694, (_e1694 > 0i)))];
let _e1721 = ((((_e1623 <= _e1676) && ((_e1298.member.x >= (_e1623 - _e1404)) && (_e1298.member.x <= (_e1676 + _e1404)))) && ((_e1298.member.y >= (_e1634 - _e1404)) && (_e1298.member.y <= (_e1687 + _e1404)))) && ((_e1298.member.z >= (_e1646 - _e1404)) && (_e1298.member.z <= (_e1699 + _e1404))));
let _e1722 = local_20.member_1;
if (_e1722 < 2u) {
let _e1724 = local_20.member_1;
phi_3092_ = _e1724;
} else {
phi_3092_ = 2u;
}
let _e1726 = phi_3092_;
if (_e1721 && (_e1577.member > _e1726)) {
phi_6479_ = _e1575;
phi_6480_ = type_17((_e1577.member - 1u), (_e1577.member_1 << bitcast<u32>(2i)));
} else {
if _e1721 {
local_15.member = _e1577.member;
local_15.member_1 = _e1577.member_1;
let _e1731 = local_15.member_1;
let _e1732 = local_20.member_1;
if (_e1732 < 2u) {
let _e1734 = local_20.member_1;
phi_3123_ = _e1734;
} else {
phi_3123_ = 2u;
}
let _e1736 = phi_3123_;
let _e1742 = local_20.member_3;
let _e1743 = local_20.member_4;
let _e1746 = local_20.member_4;
local_16 = 0u;
phi_3147_ = 0u;
loop {
let _e1752 = phi_3147_;
local_39 = _e1752;
let _e1753 = local_16;
let _e1754 = (_e1753 < select(0u, 16u, ((((_e1731 << bitcast<u32>(((2u * _e1736) & 31u))) + 16u) <= _e1746) && ((_e1742 + (24u * _e1743)) <= _e142))));
if _e1754 {
let _e1755 = local_15.member_1;
let _e1756 = local_16;
local_13 = _e1756;
let _e1757 = local_20.member_3;
let _e1758 = local_20.member_4;
let _e1761 = local_20.member_1;
if (_e1761 < 2u) {
let _e1763 = local_20.member_1;
phi_3183_ = _e1763;
} else {
phi_3183_ = 2u;
}
let _e1765 = phi_3183_;
local_14 = ((_e1757 + (18u * _e1758)) + (_e1755 << bitcast<u32>(((2u * _e1765) & 31u))));
let _e1771 = local_14;
let _e1773 = local_13;
let _e1778 = global_4.member[bitcast<u32>((bitcast<i32>(_e1771) + bitcast<i32>(_e1773)))];
let _e1779 = local_14;
let _e1780 = local_20.member_4;
let _e1783 = local_13;
let _e1788 = global_4.member[bitcast<u32>((bitcast<i32>((_e1779 + _e1780)) + bitcast<i32>(_e1783)))];
let _e1789 = local_14;
let _e1790 = local_20.member_4;
let _e1794 = local_13;
let _e1799 = global_4.member[bitcast<u32>((bitcast<i32>((_e1789 + (2u * _e1790))) + bitcast<i32>(_e1794)))];
let _e1800 = local_15.member_1;
let _e1801 = local_16;
local_11 = _e1801;
let _e1802 = local_20.member_3;
let _e1803 = local_20.member_4;
let _e1806 = local_20.member_1;
if (_e1806 < 2u) {
let _e1808 = local_20.member_1;
phi_3254_ = _e1808;
} else {
phi_3254_ = 2u;
}
let _e1810 = phi_3254_;
local_12 = ((_e1802 + (21u * _e1803)) + (_e1800 << bitcast<u32>(((2u * _e1810) & 31u))));
let _e1816 = local_12;
let _e1818 = local_11;
let _e1823 = global_4.member[bitcast<u32>((bitcast<i32>(_e1816) + bitcast<i32>(_e1818)))];
let _e1824 = local_12;
let _e1825 = local_20.member_4;
let _e1828 = local_11;
let _e1833 = global_4.member[bitcast<u32>((bitcast<i32>((_e1824 + _e1825)) + bitcast<i32>(_e1828)))];
let _e1834 = local_12;
let _e1835 = local_20.member_4;
let _e1839 = local_11;
let _e1844 = global_4.member[bitcast<u32>((bitcast<i32>((_e1834 + (2u * _e1835))) + bitcast<i32>(_e1839)))];
let _e1864 = local_16;
let _e1865 = local_15.member_1;
let _e1866 = local_20.member_1;
if (_e1866 < 2u) {
let _e1868 = local_20.member_1;
phi_3344_ = _e1868;
} else {
phi_3344_ = 2u;
}
let _e1870 = phi_3344_;
let _e1872 = ((2u * _e1870) & 31u);
let _e1875 = ((_e1865 << bitcast<u32>(_e1872)) + _e1864);
let _e1876 = (_e1875 & 1431655765u);
let _e1880 = ((_e1876 | (_e1876 >> bitcast<u32>(1i))) & 858993459u);
let _e1884 = ((_e1880 | (_e1880 >> bitcast<u32>(2i))) & 252645135u);
let _e1888 = ((_e1884 | (_e1884 >> bitcast<u32>(4i))) & 16711935u);
let _e1895 = ((_e1875 >> bitcast<u32>(1i)) & 1431655765u);
let _e1899 = ((_e1895 | (_e1895 >> bitcast<u32>(1i))) & 858993459u);
let _e1903 = ((_e1899 | (_e1899 >> bitcast<u32>(2i))) & 252645135u);
let _e1907 = ((_e1903 | (_e1903 >> bitcast<u32>(4i))) & 16711935u);
let _e1921 = local_16;
let _e1926 = local_16;
local_16 = (_e1926 + 1u);
phi_3148_ = (_e1752 | (select(0u, 1u, ((((_e1864 < (1u << bitcast<u32>(_e1872))) && (((_e1888 | (_e1888 >> bitcast<u32>(8i))) & 65535u) < _e1408)) && (((_e1907 | (_e1907 >> bitcast<u32>(8i))) & 65535u) < _e1408)) && ((((_e1778 <= _e1823) && ((_e1298.member.x >= (_e1778 - _e1404)) && (_e1298.member.x <= (_e1823 + _e1404)))) && ((_e1298.member.y >= (_e1788 - _e1404)) && (_e1298.member.y <= (_e1833 + _e1404)))) && ((_e1298.member.z >= (_e1799 - _e1404)) && (_e1298.member.z <= (_e1844 + _e1404)))))) << bitcast<u32>((_e1921 & 31u))));
} else {
phi_3148_ = u32();
}
let _e1929 = phi_3148_;
continue;
continuing {
phi_3147_ = _e1929;
break if !(_e1754);
}
}
let _e4731 = local_39;
phi_3395_ = _e4731;
} else {
phi_3395_ = 0u;
}
let _e1932 = phi_3395_;
phi_3397_ = _e1575;
phi_3400_ = 0u;
loop {
let _e1934 = phi_3397_;
let _e1936 = phi_3400_;
local_41 = _e1934;
let _e1939 = (_e1932 >> bitcast<u32>((_e1936 & 31u)));
let _e1940 = (_e1939 == 0u);
if _e1940 {
phi_3398_ = vec3<f32>();
phi_3401_ = u32();
} else {
if ((_e1939 & 1u) == 0u) {
phi_6447_ = _e1934;
} else {
let _e1943 = local_20.member_1;
if (_e1943 < 2u) {
let _e1945 = local_20.member_1;
phi_3429_ = _e1945;
} else {
phi_3429_ = 2u;
}
let _e1947 = phi_3429_;
let _e1949 = ((2u * _e1947) & 31u);
let _e1952 = ((_e1577.member_1 << bitcast<u32>(_e1949)) + _e1936);
let _e1953 = (_e1952 & 1431655765u);
let _e1957 = ((_e1953 | (_e1953 >> bitcast<u32>(1i))) & 858993459u);
let _e1961 = ((_e1957 | (_e1957 >> bitcast<u32>(2i))) & 252645135u);
let _e1965 = ((_e1961 | (_e1961 >> bitcast<u32>(4i))) & 16711935u);
let _e1969 = ((_e1965 | (_e1965 >> bitcast<u32>(8i))) & 65535u);
let _e1972 = ((_e1952 >> bitcast<u32>(1i)) & 1431655765u);
let _e1976 = ((_e1972 | (_e1972 >> bitcast<u32>(1i))) & 858993459u);
let _e1980 = ((_e1976 | (_e1976 >> bitcast<u32>(2i))) & 252645135u);
let _e1984 = ((_e1980 | (_e1980 >> bitcast<u32>(4i))) & 16711935u);
let _e1988 = ((_e1984 | (_e1984 >> bitcast<u32>(8i))) & 65535u);
if (((_e1936 < (1u << bitcast<u32>(_e1949))) && (_e1969 < _e1408)) && (_e1988 < _e1408)) {
phi_3475_ = bitcast<i32>(((_e1988 * _e1408) + _e1969));
} else {
phi_3475_ = 0i;
}
let _e2000 = phi_3475_;
local_8 = bitcast<i32>((_e1414 * _e1418));
local_9 = _e2000;
local_10 = bitcast<i32>((_e1408 * _e1408));
let _e2001 = local_8;
let _e2002 = local_9;
let _e2003 = (_e2001 + _e2002);
let _e2005 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e2007 = select(_e2005, _e2003, (_e2003 < _e2005));
let _e2012 = global_3.member[bitcast<u32>(select(0i, _e2007, (_e2007 > 0i)))];
let _e2013 = local_8;
let _e2014 = local_10;
let _e2016 = local_9;
let _e2017 = ((_e2013 + _e2014) + _e2016);
let _e2019 = select(_e2005, _e2017, (_e2017 < _e2005));
let _e2024 = global_3.member[bitcast<u32>(select(0i, _e2019, (_e2019 > 0i)))];
let _e2025 = local_8;
let _e2026 = local_10;
let _e2029 = local_9;
let _e2030 = ((_e2025 + (2i * _e2026)) + _e2029);
let _e2032 = select(_e2005, _e2030, (_e2030 < _e2005));
let _e2037 = global_3.member[bitcast<u32>(select(0i, _e2032, (_e2032 > 0i)))];
let _e2038 = local_8;
let _e2039 = local_10;
let _e2042 = local_9;
let _e2043 = ((_e2038 + (3i * _e2039)) + _e2042);
let _e2045 = select(_e2005, _e2043, (_e2043 < _e2005));
let _e2050 = global_3.member[bitcast<u32>(select(0i, _e2045, (_e2045 > 0i)))];
let _e2051 = local_8;
let _e2052 = local_10;
let _e2055 = local_9;
let _e2056 = ((_e2051 + (4i * _e2052)) + _e2055);
let _e2058 = select(_e2005, _e2056, (_e2056 < _e2005));
let _e2063 = global_3.member[bitcast<u32>(select(0i, _e2058, (_e2058 > 0i)))];
let _e2064 = local_8;
let _e2065 = local_10;
let _e2068 = local_9;
let _e2069 = ((_e2064 + (5i * _e2065)) + _e2068);
let _e2071 = select(_e2005, _e2069, (_e2069 < _e2005));
let _e2076 = global_3.member[bitcast<u32>(select(0i, _e2071, (_e2071 > 0i)))];
let _e2077 = local_8;
let _e2078 = local_10;
let _e2081 = local_9;
let _e2082 = ((_e2077 + (6i * _e2078)) + _e2081);
let _e2084 = select(_e2005, _e2082, (_e2082 < _e2005));
let _e2089 = global_3.member[bitcast<u32>(select(0i, _e2084, (_e2084 > 0i)))];
let _e2090 = local_8;
let _e2091 = local_10;
let _e2094 = local_9;
let _e2095 = ((_e2090 + (7i * _e2091)) + _e2094);
let _e2097 = select(_e2005, _e2095, (_e2095 < _e2005));
let _e2102 = global_3.member[bitcast<u32>(select(0i, _e2097, (_e2097 > 0i)))];
let _e2103 = local_8;
let _e2104 = local_10;
let _e2107 = local_9;
let _e2108 = ((_e2103 + (8i * _e2104)) + _e2107);
let _e2110 = select(_e2005, _e2108, (_e2108 < _e2005));
let _e2115 = global_3.member[bitcast<u32>(select(0i, _e2110, (_e2110 > 0i)))];
let _e2116 = local_8;
let _e2117 = local_10;
let _e2120 = local_9;
let _e2121 = ((_e2116 + (9i * _e2117)) + _e2120);
let _e2123 = select(_e2005, _e2121, (_e2121 < _e2005));
let _e2128 = global_3.member[bitcast<u32>(select(0i, _e2123, (_e2123 > 0i)))];
let _e2129 = local_8;
let _e2130 = local_10;
let _e2133 = local_9;
let _e2134 = ((_e2129 + (10i * _e2130)) + _e2133);
let _e2136 = select(_e2005, _e2134, (_e2134 < _e2005));
let _e2141 = global_3.member[bitcast<u32>(select(0i, _e2136, (_e2136 > 0i)))];
let _e2142 = local_8;
let _e2143 = local_10;
let _e2146 = local_9;
let _e2147 = ((_e2142 + (11i * _e2143)) + _e2146);
let _e2149 = select(_e2005, _e2147, (_e2147 < _e2005));
let _e2154 = global_3.member[bitcast<u32>(select(0i, _e2149, (_e2149 > 0i)))];
let _e2155 = local_8;
let _e2156 = local_10;
let _e2159 = local_9;
let _e2160 = ((_e2155 + (12i * _e2156)) + _e2159);
let _e2162 = select(_e2005, _e2160, (_e2160 < _e2005));
let _e2167 = global_3.member[bitcast<u32>(select(0i, _e2162, (_e2162 > 0i)))];
let _e2168 = local_8;
let _e2169 = local_10;
let _e2172 = local_9;
let _e2173 = ((_e2168 + (13i * _e2169)) + _e2172);
let _e2175 = select(_e2005, _e2173, (_e2173 < _e2005));
let _e2180 = global_3.member[bitcast<u32>(select(0i, _e2175, (_e2175 > 0i)))];
let _e2181 = local_8;
let _e2182 = local_10;
let _e2185 = local_9;
let _e2186 = ((_e2181 + (14i * _e2182)) + _e2185);
let _e2188 = select(_e2005, _e2186, (_e2186 < _e2005));
let _e2193 = global_3.member[bitcast<u32>(select(0i, _e2188, (_e2188 > 0i)))];
let _e2194 = local_8;
let _e2195 = local_10;
let _e2198 = local_9;
let _e2199 = ((_e2194 + (15i * _e2195)) + _e2198);
let _e2201 = select(_e2005, _e2199, (_e2199 < _e2005));
let _e2206 = global_3.member[bitcast<u32>(select(0i, _e2201, (_e2201 > 0i)))];
let _e2207 = local_8;
let _e2208 = local_10;
let _e2211 = local_9;
let _e2212 = ((_e2207 + (16i * _e2208)) + _e2211);
let _e2214 = select(_e2005, _e2212, (_e2212 < _e2005));
let _e2219 = global_3.member[bitcast<u32>(select(0i, _e2214, (_e2214 > 0i)))];
let _e2220 = local_8;
let _e2221 = local_10;
let _e2224 = local_9;
let _e2225 = ((_e2220 + (17i * _e2221)) + _e2224);
let _e2227 = select(_e2005, _e2225, (_e2225 < _e2005));
let _e2232 = global_3.member[bitcast<u32>(select(0i, _e2227, (_e2227 > 0i)))];
let _e2233 = local_8;
let _e2234 = local_10;
let _e2237 = local_9;
let _e2238 = ((_e2233 + (18i * _e2234)) + _e2237);
let _e2240 = select(_e2005, _e2238, (_e2238 < _e2005));
let _e2245 = global_3.member[bitcast<u32>(select(0i, _e2240, (_e2240 > 0i)))];
let _e2246 = local_8;
let _e2247 = local_10;
let _e2250 = local_9;
let _e2251 = ((_e2246 + (19i * _e2247)) + _e2250);
let _e2253 = select(_e2005, _e2251, (_e2251 < _e2005));
let _e2258 = global_3.member[bitcast<u32>(select(0i, _e2253, (_e2253 > 0i)))];
let _e2259 = local_8;
let _e2260 = local_10;
let _e2263 = local_9;
let _e2264 = ((_e2259 + (20i * _e2260)) + _e2263);
let _e2266 = select(_e2005, _e2264, (_e2264 < _e2005));
let _e2271 = global_3.member[bitcast<u32>(select(0i, _e2266, (_e2266 > 0i)))];
let _e2272 = local_8;
let _e2273 = local_10;
let _e2276 = local_9;
let _e2277 = ((_e2272 + (23i * _e2273)) + _e2276);
let _e2279 = select(_e2005, _e2277, (_e2277 < _e2005));
let _e2284 = global_3.member[bitcast<u32>(select(0i, _e2279, (_e2279 > 0i)))];
let _e2285 = local_8;
let _e2286 = local_10;
let _e2289 = local_9;
let _e2290 = ((_e2285 + (24i * _e2286)) + _e2289);
let _e2292 = select(_e2005, _e2290, (_e2290 < _e2005));
let _e2297 = global_3.member[bitcast<u32>(select(0i, _e2292, (_e2292 > 0i)))];
let _e2302 = (((_e1298.member_1.x * _e2050) + (_e1298.member_1.y * _e2063)) + (_e1298.member_1.z * _e2076));
let _e2305 = bitcast<f32>((bitcast<u32>(_e2302) & 2147483647u));
if (_e2305 < 1e-6f) {
phi_6430_ = vec3<f32>();
phi_6431_ = true;
} else {
let _e2307 = (1f / _e2302);
let _e2316 = ((((_e1298.member_1.x * (_e1298.member.x - _e2012)) + (_e1298.member_1.y * (_e1298.member.y - _e2024))) + (_e1298.member_1.z * (_e1298.member.z - _e2037))) * _e2307);
let _e2320 = (_e2089 + (_e2167 * _e2316));
let _e2321 = (_e2102 + (_e2180 * _e2316));
let _e2322 = (_e2115 + (_e2193 * _e2316));
let _e2328 = ((((_e1298.member_1.x * _e2320) + (_e1298.member_1.y * _e2321)) + (_e1298.member_1.z * _e2322)) * _e2307);
let _e2332 = (_e2320 - (_e2050 * _e2328));
let _e2333 = (_e2321 - (_e2063 * _e2328));
let _e2334 = (_e2322 - (_e2076 * _e2328));
let _e2338 = (_e2128 + (_e2206 * _e2316));
let _e2339 = (_e2141 + (_e2219 * _e2316));
let _e2340 = (_e2154 + (_e2232 * _e2316));
let _e2346 = ((((_e1298.member_1.x * _e2338) + (_e1298.member_1.y * _e2339)) + (_e1298.member_1.z * _e2340)) * _e2307);
let _e2350 = (_e2338 - (_e2050 * _e2346));
let _e2351 = (_e2339 - (_e2063 * _e2346));
let _e2352 = (_e2340 - (_e2076 * _e2346));
let _e2388 = (((0.5f * (bitcast<f32>((bitcast<u32>((((_e2332 * _e2050) + (_e2333 * _e2063)) + (_e2334 * _e2076))) & 2147483647u)) + bitcast<f32>((bitcast<u32>((((_e2350 * _e2050) + (_e2351 * _e2063)) + (_e2352 * _e2076))) & 2147483647u)))) + bitcast<f32>((bitcast<u32>((((_e1371 * _e2050) + (_e1372 * _e2063)) + (_e1373 * _e2076))) & 2147483647u))) + bitcast<f32>((bitcast<u32>((((_e1383 * _e2050) + (_e1384 * _e2063)) + (_e1385 * _e2076))) & 2147483647u)));
if ((_e2316 < (-(0.05f) - _e2388)) || (bitcast<f32>((bitcast<u32>((_e2316 - _e2297)) & 2147483647u)) > (_e2388 + 0.05f))) {
phi_6425_ = vec3<f32>();
phi_6426_ = true;
} else {
let _e2405 = (_e1298.member.x - (_e2012 + (_e2050 * _e2316)));
let _e2406 = (_e1298.member.y - (_e2024 + (_e2063 * _e2316)));
let _e2407 = (_e1298.member.z - (_e2037 + (_e2076 * _e2316)));
let _e2412 = (((_e2332 * _e2332) + (_e2333 * _e2333)) + (_e2334 * _e2334));
let _e2415 = sqrt(select(0f, _e2412, (_e2412 > 0f)));
let _e2420 = (((_e2350 * _e2350) + (_e2351 * _e2351)) + (_e2352 * _e2352));
let _e2423 = sqrt(select(0f, _e2420, (_e2420 > 0f)));
let _e2438 = (1f / (((((_e1372 * _e1385) - (_e1373 * _e1384)) * _e1298.member_1.x) + (((_e1373 * _e1383) - (_e1371 * _e1385)) * _e1298.member_1.y)) + (((_e1371 * _e1384) - (_e1372 * _e1383)) * _e1298.member_1.z)));
let _e2452 = (((((_e2333 * _e1385) - (_e2334 * _e1384)) * _e1298.member_1.x) + (((_e2334 * _e1383) - (_e2332 * _e1385)) * _e1298.member_1.y)) + (((_e2332 * _e1384) - (_e2333 * _e1383)) * _e1298.member_1.z));
let _e2497 = (((((_e1372 * _e2352) - (_e1373 * _e2351)) * _e1298.member_1.x) + (((_e1373 * _e2350) - (_e1371 * _e2352)) * _e1298.member_1.y)) + (((_e1371 * _e2351) - (_e1372 * _e2350)) * _e1298.member_1.z));
let _e2501 = bitcast<f32>((bitcast<u32>((_e2452 * _e2438)) & 2147483647u));
let _e2504 = bitcast<f32>((bitcast<u32>(((((((_e2351 * _e1385) - (_e2352 * _e1384)) * _e1298.member_1.x) + (((_e2352 * _e1383) - (_e2350 * _e1385)) * _e1298.member_1.y)) + (((_e2350 * _e1384) - (_e2351 * _e1383)) * _e1298.member_1.z)) * _e2438)) & 2147483647u));
let _e2508 = bitcast<f32>((bitcast<u32>(((((((_e1372 * _e2334) - (_e1373 * _e2333)) * _e1298.member_1.x) + (((_e1373 * _e2332) - (_e1371 * _e2334)) * _e1298.member_1.y)) + (((_e1371 * _e2333) - (_e1372 * _e2332)) * _e1298.member_1.z)) * _e2438)) & 2147483647u));
let _e2511 = bitcast<f32>((bitcast<u32>((_e2497 * _e2438)) & 2147483647u));
if (((_e2501 + _e2504) < 1f) && ((_e2508 + _e2511) < 1f)) {
let _e2950 = ((((((_e2406 * _e1385) - (_e2407 * _e1384)) * _e1298.member_1.x) + (((_e2407 * _e1383) - (_e2405 * _e1385)) * _e1298.member_1.y)) + (((_e2405 * _e1384) - (_e2406 * _e1383)) * _e1298.member_1.z)) * _e2438);
let _e2965 = ((((((_e1372 * _e2407) - (_e1373 * _e2406)) * _e1298.member_1.x) + (((_e1373 * _e2405) - (_e1371 * _e2407)) * _e1298.member_1.y)) + (((_e1371 * _e2406) - (_e1372 * _e2405)) * _e1298.member_1.z)) * _e2438);
let _e2966 = (1e-4f * 1f);
let _e2968 = select(_e2504, _e2501, (_e2501 > _e2504));
let _e2970 = select(_e2966, _e2968, (_e2968 > _e2966));
let _e2972 = select(_e2504, _e2501, (_e2501 < _e2504));
let _e2974 = select(_e2966, _e2972, (_e2972 > _e2966));
let _e2976 = (0.5f * (_e2970 + _e2974));
let _e2977 = (0.5f / _e2974);
let _e2978 = (1f / _e2970);
let _e2979 = (1f / 1f);
let _e2980 = (0.5f * 1f);
let _e2981 = (_e2950 + _e2980);
let _e2982 = -(_e2981);
let _e2985 = (_e2976 - select(_e2982, _e2981, (_e2981 > _e2982)));
let _e2987 = select(0f, _e2985, (_e2985 > 0f));
let _e2989 = select(_e2974, _e2987, (_e2987 < _e2974));
let _e2992 = (_e2985 - _e2974);
let _e2996 = (((_e2989 * (_e2989 * _e2977)) + select(0f, _e2992, (_e2992 > 0f))) * _e2978);
let _e3000 = (_e2950 - _e2980);
let _e3001 = -(_e3000);
let _e3004 = (_e2976 - select(_e3001, _e3000, (_e3000 > _e3001)));
let _e3006 = select(0f, _e3004, (_e3004 > 0f));
let _e3008 = select(_e2974, _e3006, (_e3006 < _e2974));
let _e3011 = (_e3004 - _e2974);
let _e3015 = (((_e3008 * (_e3008 * _e2977)) + select(0f, _e3011, (_e3011 > 0f))) * _e2978);
let _e3022 = select(_e2511, _e2508, (_e2508 > _e2511));
let _e3024 = select(_e2966, _e3022, (_e3022 > _e2966));
let _e3026 = select(_e2511, _e2508, (_e2508 < _e2511));
let _e3028 = select(_e2966, _e3026, (_e3026 > _e2966));
let _e3030 = (0.5f * (_e3024 + _e3028));
let _e3031 = (0.5f / _e3028);
let _e3032 = (1f / _e3024);
let _e3033 = (_e2965 + _e2980);
let _e3034 = -(_e3033);
let _e3037 = (_e3030 - select(_e3034, _e3033, (_e3033 > _e3034)));
let _e3039 = select(0f, _e3037, (_e3037 > 0f));
let _e3041 = select(_e3028, _e3039, (_e3039 < _e3028));
let _e3044 = (_e3037 - _e3028);
let _e3048 = (((_e3041 * (_e3041 * _e3031)) + select(0f, _e3044, (_e3044 > 0f))) * _e3032);
let _e3052 = (_e2965 - _e2980);
let _e3053 = -(_e3052);
let _e3056 = (_e3030 - select(_e3053, _e3052, (_e3052 > _e3053)));
let _e3058 = select(0f, _e3056, (_e3056 > 0f));
let _e3060 = select(_e3028, _e3058, (_e3058 < _e3028));
let _e3063 = (_e3056 - _e3028);
let _e3067 = (((_e3060 * (_e3060 * _e3031)) + select(0f, _e3063, (_e3063 > 0f))) * _e3032);
phi_5355_ = ((((select(_e2996, (1f - _e2996), (_e2981 >= 0f)) - select(_e3015, (1f - _e3015), (_e3000 >= 0f))) * _e2979) * ((select(_e3048, (1f - _e3048), (_e3033 >= 0f)) - select(_e3067, (1f - _e3067), (_e3052 >= 0f))) * _e2979)) * bitcast<f32>((bitcast<u32>(_e2438) & 2147483647u)));
} else {
let _e2529 = (((((_e2333 * _e2352) - (_e2334 * _e2351)) * _e1298.member_1.x) + (((_e2334 * _e2350) - (_e2332 * _e2352)) * _e1298.member_1.y)) + (((_e2332 * _e2351) - (_e2333 * _e2350)) * _e1298.member_1.z));
let _e2530 = (1f / _e2529);
if (bitcast<f32>((bitcast<u32>(_e2529) & 2147483647u)) > ((0.5f * _e2415) * _e2423)) {
let _e2759 = ((((((_e2406 * _e2352) - (_e2407 * _e2351)) * _e1298.member_1.x) + (((_e2407 * _e2350) - (_e2405 * _e2352)) * _e1298.member_1.y)) + (((_e2405 * _e2351) - (_e2406 * _e2350)) * _e1298.member_1.z)) * _e2530);
let _e2774 = ((((((_e2333 * _e2407) - (_e2334 * _e2406)) * _e1298.member_1.x) + (((_e2334 * _e2405) - (_e2332 * _e2407)) * _e1298.member_1.y)) + (((_e2332 * _e2406) - (_e2333 * _e2405)) * _e1298.member_1.z)) * _e2530);
let _e2809 = bitcast<f32>((bitcast<u32>((_e2497 * _e2530)) & 2147483647u));
let _e2812 = bitcast<f32>((bitcast<u32>(((((((_e1384 * _e2352) - (_e1385 * _e2351)) * _e1298.member_1.x) + (((_e1385 * _e2350) - (_e1383 * _e2352)) * _e1298.member_1.y)) + (((_e1383 * _e2351) - (_e1384 * _e2350)) * _e1298.member_1.z)) * _e2530)) & 2147483647u));
let _e2814 = select(_e2812, _e2809, (_e2809 > _e2812));
let _e2816 = select(1e-3f, _e2814, (_e2814 > 1e-3f));
let _e2819 = bitcast<f32>((bitcast<u32>(((((((_e2333 * _e1373) - (_e2334 * _e1372)) * _e1298.member_1.x) + (((_e2334 * _e1371) - (_e2332 * _e1373)) * _e1298.member_1.y)) + (((_e2332 * _e1372) - (_e2333 * _e1371)) * _e1298.member_1.z)) * _e2530)) & 2147483647u));
let _e2822 = bitcast<f32>((bitcast<u32>((_e2452 * _e2530)) & 2147483647u));
let _e2824 = select(_e2822, _e2819, (_e2819 > _e2822));
let _e2826 = select(1e-3f, _e2824, (_e2824 > 1e-3f));
let _e2827 = (1e-4f * _e2816);
let _e2829 = select(_e2827, 1f, (1f > _e2827));
let _e2831 = select(_e2827, 0f, (0f > _e2827));
let _e2833 = (0.5f * (_e2829 + _e2831));
let _e2834 = (0.5f / _e2831);
let _e2835 = (1f / _e2829);
let _e2837 = (0.5f * _e2816);
let _e2838 = (_e2759 + _e2837);
let _e2839 = -(_e2838);
let _e2842 = (_e2833 - select(_e2839, _e2838, (_e2838 > _e2839)));
let _e2844 = select(0f, _e2842, (_e2842 > 0f));
let _e2846 = select(_e2831, _e2844, (_e2844 < _e2831));
let _e2849 = (_e2842 - _e2831);
let _e2853 = (((_e2846 * (_e2846 * _e2834)) + select(0f, _e2849, (_e2849 > 0f))) * _e2835);
let _e2857 = (_e2759 - _e2837);
let _e2858 = -(_e2857);
let _e2861 = (_e2833 - select(_e2858, _e2857, (_e2857 > _e2858)));
let _e2863 = select(0f, _e2861, (_e2861 > 0f));
let _e2865 = select(_e2831, _e2863, (_e2863 < _e2831));
let _e2868 = (_e2861 - _e2831);
let _e2872 = (((_e2865 * (_e2865 * _e2834)) + select(0f, _e2868, (_e2868 > 0f))) * _e2835);
let _e2878 = (1e-4f * _e2826);
let _e2880 = select(_e2878, 1f, (1f > _e2878));
let _e2882 = select(_e2878, 0f, (0f > _e2878));
let _e2884 = (0.5f * (_e2880 + _e2882));
let _e2885 = (0.5f / _e2882);
let _e2886 = (1f / _e2880);
let _e2888 = (0.5f * _e2826);
let _e2889 = (_e2774 + _e2888);
let _e2890 = -(_e2889);
let _e2893 = (_e2884 - select(_e2890, _e2889, (_e2889 > _e2890)));
let _e2895 = select(0f, _e2893, (_e2893 > 0f));
let _e2897 = select(_e2882, _e2895, (_e2895 < _e2882));
let _e2900 = (_e2893 - _e2882);
let _e2904 = (((_e2897 * (_e2897 * _e2885)) + select(0f, _e2900, (_e2900 > 0f))) * _e2886);
let _e2908 = (_e2774 - _e2888);
let _e2909 = -(_e2908);
let _e2912 = (_e2884 - select(_e2909, _e2908, (_e2908 > _e2909)));
let _e2914 = select(0f, _e2912, (_e2912 > 0f));
let _e2916 = select(_e2882, _e2914, (_e2914 < _e2882));
let _e2919 = (_e2912 - _e2882);
let _e2923 = (((_e2916 * (_e2916 * _e2885)) + select(0f, _e2919, (_e2919 > 0f))) * _e2886);
phi_5354_ = ((((select(_e2853, (1f - _e2853), (_e2838 >= 0f)) - select(_e2872, (1f - _e2872), (_e2857 >= 0f))) * (1f / _e2816)) * ((select(_e2904, (1f - _e2904), (_e2889 >= 0f)) - select(_e2923, (1f - _e2923), (_e2908 >= 0f))) * (1f / _e2826))) * bitcast<f32>((bitcast<u32>(_e2530) & 2147483647u)));
} else {
let _e2537 = (_e2415 >= _e2423);
let _e2538 = select(_e2350, _e2332, _e2537);
let _e2539 = select(_e2351, _e2333, _e2537);
let _e2540 = select(_e2352, _e2334, _e2537);
let _e2541 = select(_e2332, _e2350, _e2537);
let _e2542 = select(_e2333, _e2351, _e2537);
let _e2543 = select(_e2334, _e2352, _e2537);
let _e2548 = (((_e2538 * _e2538) + (_e2539 * _e2539)) + (_e2540 * _e2540));
let _e2551 = sqrt(select(0f, _e2548, (_e2548 > 0f)));
let _e2554 = (1f / select(1e-30f, _e2551, (_e2551 > 1e-30f)));
let _e2555 = (_e2538 * _e2554);
let _e2556 = (_e2539 * _e2554);
let _e2557 = (_e2540 * _e2554);
let _e2560 = ((_e1298.member_1.y * _e2557) - (_e1298.member_1.z * _e2556));
let _e2563 = ((_e1298.member_1.z * _e2555) - (_e1298.member_1.x * _e2557));
let _e2566 = ((_e1298.member_1.x * _e2556) - (_e1298.member_1.y * _e2555));
let _e2574 = bitcast<f32>((bitcast<u32>((((_e1371 * _e2555) + (_e1372 * _e2556)) + (_e1373 * _e2557))) & 2147483647u));
let _e2582 = bitcast<f32>((bitcast<u32>((((_e1383 * _e2555) + (_e1384 * _e2556)) + (_e1385 * _e2557))) & 2147483647u));
let _e2584 = select(_e2582, _e2574, (_e2574 > _e2582));
let _e2585 = (1e-3f * _e2551);
let _e2587 = select(_e2585, _e2584, (_e2584 > _e2585));
let _e2595 = bitcast<f32>((bitcast<u32>((((_e1371 * _e2560) + (_e1372 * _e2563)) + (_e1373 * _e2566))) & 2147483647u));
let _e2603 = bitcast<f32>((bitcast<u32>((((_e1383 * _e2560) + (_e1384 * _e2563)) + (_e1385 * _e2566))) & 2147483647u));
let _e2605 = select(_e2603, _e2595, (_e2595 > _e2603));
let _e2607 = select(_e2585, _e2605, (_e2605 > _e2585));
let _e2612 = (((_e2405 * _e2555) + (_e2406 * _e2556)) + (_e2407 * _e2557));
let _e2620 = bitcast<f32>((bitcast<u32>((((_e2541 * _e2555) + (_e2542 * _e2556)) + (_e2543 * _e2557))) & 2147483647u));
let _e2621 = (1e-4f * _e2587);
let _e2623 = select(_e2620, _e2551, (_e2551 > _e2620));
let _e2625 = select(_e2621, _e2623, (_e2623 > _e2621));
let _e2627 = select(_e2620, _e2551, (_e2551 < _e2620));
let _e2629 = select(_e2621, _e2627, (_e2627 > _e2621));
let _e2631 = (0.5f * (_e2625 + _e2629));
let _e2632 = (0.5f / _e2629);
let _e2633 = (1f / _e2625);
let _e2635 = (0.5f * _e2587);
let _e2636 = (_e2612 + _e2635);
let _e2637 = -(_e2636);
let _e2640 = (_e2631 - select(_e2637, _e2636, (_e2636 > _e2637)));
let _e2642 = select(0f, _e2640, (_e2640 > 0f));
let _e2644 = select(_e2629, _e2642, (_e2642 < _e2629));
let _e2647 = (_e2640 - _e2629);
let _e2651 = (((_e2644 * (_e2644 * _e2632)) + select(0f, _e2647, (_e2647 > 0f))) * _e2633);
let _e2655 = (_e2612 - _e2635);
let _e2656 = -(_e2655);
let _e2659 = (_e2631 - select(_e2656, _e2655, (_e2655 > _e2656)));
let _e2661 = select(0f, _e2659, (_e2659 > 0f));
let _e2663 = select(_e2629, _e2661, (_e2661 < _e2629));
let _e2666 = (_e2659 - _e2629);
let _e2670 = (((_e2663 * (_e2663 * _e2632)) + select(0f, _e2666, (_e2666 > 0f))) * _e2633);
let _e2680 = (((_e2405 * _e2560) + (_e2406 * _e2563)) + (_e2407 * _e2566));
let _e2688 = bitcast<f32>((bitcast<u32>((((_e2541 * _e2560) + (_e2542 * _e2563)) + (_e2543 * _e2566))) & 2147483647u));
let _e2689 = (1e-4f * _e2607);
let _e2691 = select(0f, _e2688, (_e2688 > 0f));
let _e2693 = select(_e2689, _e2691, (_e2691 > _e2689));
let _e2695 = select(0f, _e2688, (_e2688 < 0f));
let _e2697 = select(_e2689, _e2695, (_e2695 > _e2689));
let _e2699 = (0.5f * (_e2693 + _e2697));
let _e2700 = (0.5f / _e2697);
let _e2701 = (1f / _e2693);
let _e2703 = (0.5f * _e2607);
let _e2704 = (_e2680 + _e2703);
let _e2705 = -(_e2704);
let _e2708 = (_e2699 - select(_e2705, _e2704, (_e2704 > _e2705)));
let _e2710 = select(0f, _e2708, (_e2708 > 0f));
let _e2712 = select(_e2697, _e2710, (_e2710 < _e2697));
let _e2715 = (_e2708 - _e2697);
let _e2719 = (((_e2712 * (_e2712 * _e2700)) + select(0f, _e2715, (_e2715 > 0f))) * _e2701);
let _e2723 = (_e2680 - _e2703);
let _e2724 = -(_e2723);
let _e2727 = (_e2699 - select(_e2724, _e2723, (_e2723 > _e2724)));
let _e2729 = select(0f, _e2727, (_e2727 > 0f));
let _e2731 = select(_e2697, _e2729, (_e2729 < _e2697));
let _e2734 = (_e2727 - _e2697);
let _e2738 = (((_e2731 * (_e2731 * _e2700)) + select(0f, _e2734, (_e2734 > 0f))) * _e2701);
phi_5354_ = (((select(_e2651, (1f - _e2651), (_e2636 >= 0f)) - select(_e2670, (1f - _e2670), (_e2655 >= 0f))) * (1f / _e2587)) * ((select(_e2719, (1f - _e2719), (_e2704 >= 0f)) - select(_e2738, (1f - _e2738), (_e2723 >= 0f))) * (1f / _e2607)));
}
let _e2935 = phi_5354_;
phi_5355_ = _e2935;
}
let _e3079 = phi_5355_;
let _e3080 = (_e3079 <= 0f);
if _e3080 {
phi_6424_ = vec3<f32>();
} else {
let _e3083 = (select(_e2284, _e2316, (_e2316 < _e2284)) - 0f);
let _e3087 = global_1.member.member_13.member_6;
if (_e3087 == 0u) {
phi_6091_ = _e3083;
} else {
let _e3090 = (_e3083 / f32(_e3087));
phi_5378_ = 0u;
phi_5381_ = 0f;
loop {
let _e3092 = phi_5378_;
let _e3094 = phi_5381_;
local_40 = _e3094;
let _e3097 = ((_e3092 < _e3087) && (_e3083 > 0f));
if _e3097 {
let _e3100 = (0f + (_e3090 * f32(_e3092)));
let _e3101 = (_e3100 + _e3090);
let _e3103 = (0.5f * (_e3100 + _e3101));
let _e3104 = (_e3101 - _e3100);
let _e3105 = (0.28867513f * _e3104);
let _e3106 = (_e3103 - _e3105);
let _e3116 = global_1.member.member_13.member_7;
let _e3117 = bitcast<i32>(_e3116);
let _e3121 = global_1.member.member_13.member_8;
let _e3122 = bitcast<i32>(_e3121);
let _e3126 = global_1.member.member_13.member_9;
let _e3127 = bitcast<i32>(_e3126);
let _e3131 = global_1.member.member_13.member_4;
let _e3138 = global_1.member.member_13.member_5;
let _e3142 = f32(_e3117);
let _e3144 = (_e3138.member - _e3131.member);
let _e3147 = (((((_e2012 + (_e2050 * _e3106)) - _e3131.member) / _e3144) * _e3142) - 0.5f);
let _e3148 = (_e3142 - 1f);
let _e3150 = select(0f, _e3147, (_e3147 > 0f));
let _e3152 = select(_e3148, _e3150, (_e3150 < _e3148));
let _e3153 = f32(_e3122);
let _e3155 = (_e3138.member_1 - _e3131.member_1);
let _e3158 = (((((_e2024 + (_e2063 * _e3106)) - _e3131.member_1) / _e3155) * _e3153) - 0.5f);
let _e3159 = (_e3153 - 1f);
let _e3161 = select(0f, _e3158, (_e3158 > 0f));
let _e3163 = select(_e3159, _e3161, (_e3161 < _e3159));
let _e3164 = f32(_e3127);
let _e3166 = (_e3138.member_2 - _e3131.member_2);
let _e3169 = (((((_e2037 + (_e2076 * _e3106)) - _e3131.member_2) / _e3166) * _e3164) - 0.5f);
let _e3170 = (_e3164 - 1f);
let _e3172 = select(0f, _e3169, (_e3169 > 0f));
let _e3174 = select(_e3170, _e3172, (_e3172 < _e3170));
let _e3176 = select(0f, _e3152, (_e3152 > 0f));
let _e3178 = select(1e6f, _e3176, (_e3176 < 1e6f));
let _e3185 = select(0i, select(select(i32(_e3178), i32(-2147483648), (_e3178 < -2147483600f)), 2147483647i, (_e3178 > 2147483500f)), (_e3178 == _e3178));
let _e3189 = (_e3185 - select(0i, 1i, (_e3178 < f32(_e3185))));
let _e3191 = select(0f, _e3163, (_e3163 > 0f));
let _e3193 = select(1e6f, _e3191, (_e3191 < 1e6f));
let _e3200 = select(0i, select(select(i32(_e3193), i32(-2147483648), (_e3193 < -2147483600f)), 2147483647i, (_e3193 > 2147483500f)), (_e3193 == _e3193));
let _e3204 = (_e3200 - select(0i, 1i, (_e3193 < f32(_e3200))));
let _e3206 = select(0f, _e3174, (_e3174 > 0f));
let _e3208 = select(1e6f, _e3206, (_e3206 < 1e6f));
let _e3215 = select(0i, select(select(i32(_e3208), i32(-2147483648), (_e3208 < -2147483600f)), 2147483647i, (_e3208 > 2147483500f)), (_e3208 == _e3208));
let _e3219 = (_e3215 - select(0i, 1i, (_e3208 < f32(_e3215))));
let _e3223 = (_e3163 - f32(_e3204));
let _e3225 = (_e3174 - f32(_e3219));
local_6 = (_e3152 - f32(_e3189));
let _e3226 = (_e3189 + 1i);
let _e3228 = select(_e3226, 0i, (_e3226 < 0i));
if (_e3228 >= _e3117) {
phi_5516_ = (_e3117 - 1i);
} else {
phi_5516_ = _e3228;
}
let _e3232 = phi_5516_;
local_7 = (_e3232 - _e3189);
let _e3234 = (_e3204 + 1i);
let _e3236 = select(_e3234, 0i, (_e3234 < 0i));
if (_e3236 >= _e3122) {
phi_5529_ = (_e3122 - 1i);
} else {
phi_5529_ = _e3236;
}
let _e3240 = phi_5529_;
let _e3242 = ((_e3240 - _e3204) * _e3117);
let _e3243 = (_e3219 + 1i);
let _e3245 = select(_e3243, 0i, (_e3243 < 0i));
if (_e3245 >= _e3127) {
phi_5543_ = (_e3127 - 1i);
} else {
phi_5543_ = _e3245;
}
let _e3249 = phi_5543_;
let _e3256 = global_1.member.member_13.member_10;
let _e3257 = bitcast<i32>(_e3256);
let _e3262 = ((_e3257 + (((_e3219 * _e3122) + _e3204) * _e3117)) + _e3189);
let _e3264 = select(_e1321, _e3262, (_e3262 < _e1321));
let _e3269 = global_8.member[bitcast<u32>(select(0i, _e3264, (_e3264 > 0i)))];
let _e3270 = local_6;
let _e3273 = local_7;
let _e3274 = (_e3262 + _e3273);
let _e3276 = select(_e1321, _e3274, (_e3274 < _e1321));
let _e3281 = global_8.member[bitcast<u32>(select(0i, _e3276, (_e3276 > 0i)))];
let _e3282 = local_6;
let _e3285 = (1f - _e3223);
let _e3287 = (_e3262 + _e3242);
let _e3289 = select(_e1321, _e3287, (_e3287 < _e1321));
let _e3294 = global_8.member[bitcast<u32>(select(0i, _e3289, (_e3289 > 0i)))];
let _e3295 = local_6;
let _e3298 = local_7;
let _e3299 = (_e3287 + _e3298);
let _e3301 = select(_e1321, _e3299, (_e3299 < _e1321));
let _e3306 = global_8.member[bitcast<u32>(select(0i, _e3301, (_e3301 > 0i)))];
let _e3307 = local_6;
let _e3312 = (_e3262 + (((_e3249 - _e3219) * _e3117) * _e3122));
let _e3314 = select(_e1321, _e3312, (_e3312 < _e1321));
let _e3319 = global_8.member[bitcast<u32>(select(0i, _e3314, (_e3314 > 0i)))];
let _e3320 = local_6;
let _e3323 = local_7;
let _e3324 = (_e3312 + _e3323);
let _e3326 = select(_e1321, _e3324, (_e3324 < _e1321));
let _e3331 = global_8.member[bitcast<u32>(select(0i, _e3326, (_e3326 > 0i)))];
let _e3332 = local_6;
let _e3336 = (_e3312 + _e3242);
let _e3338 = select(_e1321, _e3336, (_e3336 < _e1321));
let _e3343 = global_8.member[bitcast<u32>(select(0i, _e3338, (_e3338 > 0i)))];
let _e3344 = local_6;
let _e3347 = local_7;
let _e3348 = (_e3336 + _e3347);
let _e3350 = select(_e1321, _e3348, (_e3348 < _e1321));
let _e3355 = global_8.member[bitcast<u32>(select(0i, _e3350, (_e3350 > 0i)))];
let _e3356 = local_6;
let _e3365 = (_e3103 + _e3105);
let _e3375 = (((((_e2012 + (_e2050 * _e3365)) - _e3131.member) / _e3144) * _e3142) - 0.5f);
let _e3377 = select(0f, _e3375, (_e3375 > 0f));
let _e3379 = select(_e3148, _e3377, (_e3377 < _e3148));
let _e3383 = (((((_e2024 + (_e2063 * _e3365)) - _e3131.member_1) / _e3155) * _e3153) - 0.5f);
let _e3385 = select(0f, _e3383, (_e3383 > 0f));
let _e3387 = select(_e3159, _e3385, (_e3385 < _e3159));
let _e3391 = (((((_e2037 + (_e2076 * _e3365)) - _e3131.member_2) / _e3166) * _e3164) - 0.5f);
let _e3393 = select(0f, _e3391, (_e3391 > 0f));
let _e3395 = select(_e3170, _e3393, (_e3393 < _e3170));
let _e3397 = select(0f, _e3379, (_e3379 > 0f));
let _e3399 = select(1e6f, _e3397, (_e3397 < 1e6f));
let _e3406 = select(0i, select(select(i32(_e3399), i32(-2147483648), (_e3399 < -2147483600f)), 2147483647i, (_e3399 > 2147483500f)), (_e3399 == _e3399));
let _e3410 = (_e3406 - select(0i, 1i, (_e3399 < f32(_e3406))));
let _e3412 = select(0f, _e3387, (_e3387 > 0f));
let _e3414 = select(1e6f, _e3412, (_e3412 < 1e6f));
let _e3421 = select(0i, select(select(i32(_e3414), i32(-2147483648), (_e3414 < -2147483600f)), 2147483647i, (_e3414 > 2147483500f)), (_e3414 == _e3414));
let _e3425 = (_e3421 - select(0i, 1i, (_e3414 < f32(_e3421))));
let _e3427 = select(0f, _e3395, (_e3395 > 0f));
let _e3429 = select(1e6f, _e3427, (_e3427 < 1e6f));
let _e3436 = select(0i, select(select(i32(_e3429), i32(-2147483648), (_e3429 < -2147483600f)), 2147483647i, (_e3429 > 2147483500f)), (_e3429 == _e3429));
let _e3440 = (_e3436 - select(0i, 1i, (_e3429 < f32(_e3436))));
let _e3444 = (_e3387 - f32(_e3425));
let _e3446 = (_e3395 - f32(_e3440));
local_4 = (_e3379 - f32(_e3410));
let _e3447 = (_e3410 + 1i);
let _e3449 = select(_e3447, 0i, (_e3447 < 0i));
if (_e3449 >= _e3117) {
phi_5859_ = (_e3117 - 1i);
} else {
phi_5859_ = _e3449;
}
let _e3453 = phi_5859_;
local_5 = (_e3453 - _e3410);
let _e3455 = (_e3425 + 1i);
let _e3457 = select(_e3455, 0i, (_e3455 < 0i));
if (_e3457 >= _e3122) {
phi_5872_ = (_e3122 - 1i);
} else {
phi_5872_ = _e3457;
}
let _e3461 = phi_5872_;
let _e3463 = ((_e3461 - _e3425) * _e3117);
let _e3464 = (_e3440 + 1i);
let _e3466 = select(_e3464, 0i, (_e3464 < 0i));
if (_e3466 >= _e3127) {
phi_5886_ = (_e3127 - 1i);
} else {
phi_5886_ = _e3466;
}
let _e3470 = phi_5886_;
let _e3478 = ((_e3257 + (((_e3440 * _e3122) + _e3425) * _e3117)) + _e3410);
let _e3480 = select(_e1321, _e3478, (_e3478 < _e1321));
let _e3485 = global_8.member[bitcast<u32>(select(0i, _e3480, (_e3480 > 0i)))];
let _e3486 = local_4;
let _e3489 = local_5;
let _e3490 = (_e3478 + _e3489);
let _e3492 = select(_e1321, _e3490, (_e3490 < _e1321));
let _e3497 = global_8.member[bitcast<u32>(select(0i, _e3492, (_e3492 > 0i)))];
let _e3498 = local_4;
let _e3501 = (1f - _e3444);
let _e3503 = (_e3478 + _e3463);
let _e3505 = select(_e1321, _e3503, (_e3503 < _e1321));
let _e3510 = global_8.member[bitcast<u32>(select(0i, _e3505, (_e3505 > 0i)))];
let _e3511 = local_4;
let _e3514 = local_5;
let _e3515 = (_e3503 + _e3514);
let _e3517 = select(_e1321, _e3515, (_e3515 < _e1321));
let _e3522 = global_8.member[bitcast<u32>(select(0i, _e3517, (_e3517 > 0i)))];
let _e3523 = local_4;
let _e3528 = (_e3478 + (((_e3470 - _e3440) * _e3117) * _e3122));
let _e3530 = select(_e1321, _e3528, (_e3528 < _e1321));
let _e3535 = global_8.member[bitcast<u32>(select(0i, _e3530, (_e3530 > 0i)))];
let _e3536 = local_4;
let _e3539 = local_5;
let _e3540 = (_e3528 + _e3539);
let _e3542 = select(_e1321, _e3540, (_e3540 < _e1321));
let _e3547 = global_8.member[bitcast<u32>(select(0i, _e3542, (_e3542 > 0i)))];
let _e3548 = local_4;
let _e3552 = (_e3528 + _e3463);
let _e3554 = select(_e1321, _e3552, (_e3552 < _e1321));
let _e3559 = global_8.member[bitcast<u32>(select(0i, _e3554, (_e3554 > 0i)))];
let _e3560 = local_4;
let _e3563 = local_5;
let _e3564 = (_e3552 + _e3563);
let _e3566 = select(_e1321, _e3564, (_e3564 < _e1321));
let _e3571 = global_8.member[bitcast<u32>(select(0i, _e3566, (_e3566 > 0i)))];
let _e3572 = local_4;
phi_5379_ = (_e3092 + 1u);
phi_5382_ = (_e3094 + ((0.5f * (((((((_e3269 * (1f - _e3270)) + (_e3281 * _e3282)) * _e3285) + (((_e3294 * (1f - _e3295)) + (_e3306 * _e3307)) * _e3223)) * (1f - _e3225)) + (((((_e3319 * (1f - _e3320)) + (_e3331 * _e3332)) * _e3285) + (((_e3343 * (1f - _e3344)) + (_e3355 * _e3356)) * _e3223)) * _e3225)) + ((((((_e3485 * (1f - _e3486)) + (_e3497 * _e3498)) * _e3501) + (((_e3510 * (1f - _e3511)) + (_e3522 * _e3523)) * _e3444)) * (1f - _e3446)) + (((((_e3535 * (1f - _e3536)) + (_e3547 * _e3548)) * _e3501) + (((_e3559 * (1f - _e3560)) + (_e3571 * _e3572)) * _e3444)) * _e3446)))) * _e3104));
} else {
phi_5379_ = u32();
phi_5382_ = f32();
}
let _e3587 = phi_5379_;
let _e3589 = phi_5382_;
continue;
continuing {
phi_5378_ = _e3587;
phi_5381_ = _e3589;
break if !(_e3097);
}
}
let _e4750 = local_40;
phi_6091_ = _e4750;
}
let _e3592 = phi_6091_;
let _e3605 = (0.25f * bitcast<f32>((bitcast<u32>((((_e1298.member_2.x * _e2050) + (_e1298.member_2.y * _e2063)) + (_e1298.member_2.z * _e2076))) & 2147483647u)));
let _e3612 = (((_e1298.member_1.x * _e500) + (_e1298.member_1.y * _e511)) + (_e1298.member_1.z * _e522));
let _e3614 = select(1f, -1f, (_e3612 > 0f));
let _e3622 = select(_e3614, -(_e3614), ((((_e1298.member_2.x * _e1298.member_1.x) + (_e1298.member_2.y * _e1298.member_1.y)) + (_e1298.member_2.z * _e1298.member_1.z)) < 0f));
let _e3623 = (_e1298.member_2.x * _e3622);
let _e3624 = (_e1298.member_2.y * _e3622);
let _e3625 = (_e1298.member_2.z * _e3622);
let _e3634 = ((((_e3623 * _e500) + (_e3624 * _e511)) + (_e3625 * _e522)) > 0f);
let _e3643 = -((((select(_e3623, (_e1298.member_1.x * _e3614), _e3634) * _e2050) + (select(_e3624, (_e1298.member_1.y * _e3614), _e3634) * _e2063)) + (select(_e3625, (_e1298.member_1.z * _e3614), _e3634) * _e2076)));
let _e3648 = -(_e3643);
let _e3658 = global_1.member.member_13.member;
let _e3663 = -((_e3658.member * _e3592));
let _e3665 = select(-87f, _e3663, (_e3663 > -87f));
let _e3667 = select(88f, _e3665, (_e3665 < 88f));
let _e3669 = ((_e3667 * 1.442695f) + 0.5f);
let _e3671 = select(-127f, _e3669, (_e3669 > -127f));
let _e3673 = select(128f, _e3671, (_e3671 < 128f));
let _e3680 = select(0i, select(select(i32(_e3673), i32(-2147483648), (_e3673 < -2147483600f)), 2147483647i, (_e3673 > 2147483500f)), (_e3673 == _e3673));
let _e3684 = (_e3680 - select(0i, 1i, (_e3673 < f32(_e3680))));
let _e3685 = f32(_e3684);
let _e3689 = ((_e3667 - (_e3685 * 0.6933594f)) - (_e3685 * -2.1219444e-4f));
let _e3711 = -((_e3658.member_1 * _e3592));
let _e3713 = select(-87f, _e3711, (_e3711 > -87f));
let _e3715 = select(88f, _e3713, (_e3713 < 88f));
let _e3717 = ((_e3715 * 1.442695f) + 0.5f);
let _e3719 = select(-127f, _e3717, (_e3717 > -127f));
let _e3721 = select(128f, _e3719, (_e3719 < 128f));
let _e3728 = select(0i, select(select(i32(_e3721), i32(-2147483648), (_e3721 < -2147483600f)), 2147483647i, (_e3721 > 2147483500f)), (_e3721 == _e3721));
let _e3732 = (_e3728 - select(0i, 1i, (_e3721 < f32(_e3728))));
let _e3733 = f32(_e3732);
let _e3737 = ((_e3715 - (_e3733 * 0.6933594f)) - (_e3733 * -2.1219444e-4f));
let _e3759 = -((_e3658.member_2 * _e3592));
let _e3761 = select(-87f, _e3759, (_e3759 > -87f));
let _e3763 = select(88f, _e3761, (_e3761 < 88f));
let _e3765 = ((_e3763 * 1.442695f) + 0.5f);
let _e3767 = select(-127f, _e3765, (_e3765 > -127f));
let _e3769 = select(128f, _e3767, (_e3767 < 128f));
let _e3776 = select(0i, select(select(i32(_e3769), i32(-2147483648), (_e3769 < -2147483600f)), 2147483647i, (_e3769 > 2147483500f)), (_e3769 == _e3769));
let _e3780 = (_e3776 - select(0i, 1i, (_e3769 < f32(_e3776))));
let _e3781 = f32(_e3780);
let _e3785 = ((_e3763 - (_e3781 * 0.6933594f)) - (_e3781 * -2.1219444e-4f));
let _e3811 = ((_e3079 * (select((select(0f, _e3648, (_e3648 > 0f)) * _e1298.member_4), select(0f, _e3643, (_e3643 > 0f)), ((_e2302 * _e3612) > 0f)) / select(_e3605, _e2305, (_e2305 > _e3605)))) * (1f / 3.1415927f));
phi_6424_ = vec3<f32>(((_e2245 * ((1f + (_e3689 * (1f + (_e3689 * (0.5f + (_e3689 * (0.16666667f + (_e3689 * (0.041666668f + (_e3689 * (0.008333334f + (_e3689 * (0.001388889f + (_e3689 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3684 + 127i)) << bitcast<u32>(23i))))) * _e3811), ((_e2258 * ((1f + (_e3737 * (1f + (_e3737 * (0.5f + (_e3737 * (0.16666667f + (_e3737 * (0.041666668f + (_e3737 * (0.008333334f + (_e3737 * (0.001388889f + (_e3737 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3732 + 127i)) << bitcast<u32>(23i))))) * _e3811), ((_e2271 * ((1f + (_e3785 * (1f + (_e3785 * (0.5f + (_e3785 * (0.16666667f + (_e3785 * (0.041666668f + (_e3785 * (0.008333334f + (_e3785 * (0.001388889f + (_e3785 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3780 + 127i)) << bitcast<u32>(23i))))) * _e3811));
}
let _e3817 = phi_6424_;
phi_6425_ = _e3817;
phi_6426_ = _e3080;
}
let _e3819 = phi_6425_;
let _e3821 = phi_6426_;
phi_6430_ = _e3819;
phi_6431_ = _e3821;
}
let _e3823 = phi_6430_;
let _e3825 = phi_6431_;
phi_6447_ = (_e1934 + select(_e3823, vec3<f32>(0f, 0f, 0f), vec3(_e3825)));
}
let _e3830 = phi_6447_;
phi_3398_ = _e3830;
phi_3401_ = (_e1936 + 1u);
}
let _e3833 = phi_3398_;
let _e3835 = phi_3401_;
continue;
continuing {
phi_3397_ = _e3833;
phi_3400_ = _e3835;
break if !(select(true, false, _e1940));
}
}
let _e3838 = local_20.member_1;
phi_6457_ = type_17(_e1577.member, (_e1577.member_1 + 1u));
loop {
let _e3842 = phi_6457_;
local_42 = _e3842;
let _e3848 = (((_e3842.member_1 & 3u) == 0u) && (_e3842.member < _e3838));
if _e3848 {
phi_6458_ = type_17((_e3842.member + 1u), (_e3842.member_1 >> bitcast<u32>(2i)));
} else {
phi_6458_ = type_17();
}
let _e3854 = phi_6458_;
continue;
continuing {
phi_6457_ = _e3854;
break if !(_e3848);
}
}
let _e4763 = local_41;
phi_6479_ = _e4763;
let _e4766 = local_42;
phi_6480_ = _e4766;
}
let _e3861 = phi_6479_;
let _e3863 = phi_6480_;
phi_2831_ = _e3861;
phi_2834_ = _e3863;
} else {
phi_2831_ = vec3<f32>();
phi_2834_ = type_17();
}
let _e3865 = phi_2831_;
let _e3867 = phi_2834_;
continue;
continuing {
phi_2830_ = _e3865;
phi_2833_ = _e3867;
break if !(_e1585);
}
}
let _e3876 = (1f / select(_e500, select(1e-12f, -1e-12f, (_e500 < 0f)), (bitcast<f32>((bitcast<u32>(_e500) & 2147483647u)) < 1e-12f)));
let _e3884 = (1f / select(_e511, select(1e-12f, -1e-12f, (_e511 < 0f)), (bitcast<f32>((bitcast<u32>(_e511) & 2147483647u)) < 1e-12f)));
let _e3892 = (1f / select(_e522, select(1e-12f, -1e-12f, (_e522 < 0f)), (bitcast<f32>((bitcast<u32>(_e522) & 2147483647u)) < 1e-12f)));
let _e3896 = global_1.member.member_13.member_4;
let _e3903 = global_1.member.member_13.member_5;
let _e3908 = ((_e3896.member - _e817) * _e3876);
let _e3910 = ((_e3903.member - _e817) * _e3876);
let _e3912 = ((_e3896.member_1 - _e818) * _e3884);
let _e3914 = ((_e3903.member_1 - _e818) * _e3884);
let _e3916 = ((_e3896.member_2 - _e819) * _e3892);
let _e3918 = ((_e3903.member_2 - _e819) * _e3892);
let _e3920 = select(_e3910, _e3908, (_e3908 < _e3910));
let _e3922 = select(_e3914, _e3912, (_e3912 < _e3914));
let _e3924 = select(_e3922, _e3920, (_e3920 > _e3922));
let _e3926 = select(_e3918, _e3916, (_e3916 < _e3918));
let _e3928 = select(_e3926, _e3924, (_e3924 > _e3926));
let _e3930 = select(_e3910, _e3908, (_e3908 > _e3910));
let _e3932 = select(_e3914, _e3912, (_e3912 > _e3914));
let _e3934 = select(_e3932, _e3930, (_e3930 < _e3932));
let _e3936 = select(_e3918, _e3916, (_e3916 > _e3918));
let _e3938 = select(_e3936, _e3934, (_e3934 < _e3936));
let _e3940 = select(0f, _e3928, (_e3928 > 0f));
let _e3942 = select(_e820, _e3938, (_e3938 < _e820));
let _e3943 = (_e3942 > _e3940);
let _e3944 = select(0f, _e3940, _e3943);
let _e3946 = (select(0f, _e3942, _e3943) - _e3944);
let _e3950 = global_1.member.member_13.member_6;
if (_e3950 == 0u) {
phi_7341_ = _e3946;
} else {
let _e3953 = (_e3946 / f32(_e3950));
phi_6628_ = 0u;
phi_6631_ = 0f;
loop {
let _e3955 = phi_6628_;
let _e3957 = phi_6631_;
local_43 = _e3957;
let _e3960 = ((_e3955 < _e3950) && (_e3946 > 0f));
if _e3960 {
let _e3963 = (_e3944 + (_e3953 * f32(_e3955)));
let _e3964 = (_e3963 + _e3953);
let _e3966 = (0.5f * (_e3963 + _e3964));
let _e3967 = (_e3964 - _e3963);
let _e3968 = (0.28867513f * _e3967);
let _e3969 = (_e3966 - _e3968);
let _e3979 = global_1.member.member_13.member_7;
let _e3980 = bitcast<i32>(_e3979);
let _e3984 = global_1.member.member_13.member_8;
let _e3985 = bitcast<i32>(_e3984);
let _e3989 = global_1.member.member_13.member_9;
let _e3990 = bitcast<i32>(_e3989);
let _e3991 = f32(_e3980);
let _e3993 = (_e3903.member - _e3896.member);
let _e3996 = (((((_e817 + (_e500 * _e3969)) - _e3896.member) / _e3993) * _e3991) - 0.5f);
let _e3997 = (_e3991 - 1f);
let _e3999 = select(0f, _e3996, (_e3996 > 0f));
let _e4001 = select(_e3997, _e3999, (_e3999 < _e3997));
let _e4002 = f32(_e3985);
let _e4004 = (_e3903.member_1 - _e3896.member_1);
let _e4007 = (((((_e818 + (_e511 * _e3969)) - _e3896.member_1) / _e4004) * _e4002) - 0.5f);
let _e4008 = (_e4002 - 1f);
let _e4010 = select(0f, _e4007, (_e4007 > 0f));
let _e4012 = select(_e4008, _e4010, (_e4010 < _e4008));
let _e4013 = f32(_e3990);
let _e4015 = (_e3903.member_2 - _e3896.member_2);
let _e4018 = (((((_e819 + (_e522 * _e3969)) - _e3896.member_2) / _e4015) * _e4013) - 0.5f);
let _e4019 = (_e4013 - 1f);
let _e4021 = select(0f, _e4018, (_e4018 > 0f));
let _e4023 = select(_e4019, _e4021, (_e4021 < _e4019));
let _e4025 = select(0f, _e4001, (_e4001 > 0f));
let _e4027 = select(1e6f, _e4025, (_e4025 < 1e6f));
let _e4034 = select(0i, select(select(i32(_e4027), i32(-2147483648), (_e4027 < -2147483600f)), 2147483647i, (_e4027 > 2147483500f)), (_e4027 == _e4027));
let _e4038 = (_e4034 - select(0i, 1i, (_e4027 < f32(_e4034))));
let _e4040 = select(0f, _e4012, (_e4012 > 0f));
let _e4042 = select(1e6f, _e4040, (_e4040 < 1e6f));
let _e4049 = select(0i, select(select(i32(_e4042), i32(-2147483648), (_e4042 < -2147483600f)), 2147483647i, (_e4042 > 2147483500f)), (_e4042 == _e4042));
let _e4053 = (_e4049 - select(0i, 1i, (_e4042 < f32(_e4049))));
let _e4055 = select(0f, _e4023, (_e4023 > 0f));
let _e4057 = select(1e6f, _e4055, (_e4055 < 1e6f));
let _e4064 = select(0i, select(select(i32(_e4057), i32(-2147483648), (_e4057 < -2147483600f)), 2147483647i, (_e4057 > 2147483500f)), (_e4057 == _e4057));
let _e4068 = (_e4064 - select(0i, 1i, (_e4057 < f32(_e4064))));
let _e4072 = (_e4012 - f32(_e4053));
let _e4074 = (_e4023 - f32(_e4068));
local_2 = (_e4001 - f32(_e4038));
let _e4075 = (_e4038 + 1i);
let _e4077 = select(_e4075, 0i, (_e4075 < 0i));
if (_e4077 >= _e3980) {
phi_6766_ = (_e3980 - 1i);
} else {
phi_6766_ = _e4077;
}
let _e4081 = phi_6766_;
local_3 = (_e4081 - _e4038);
let _e4083 = (_e4053 + 1i);
let _e4085 = select(_e4083, 0i, (_e4083 < 0i));
if (_e4085 >= _e3985) {
phi_6779_ = (_e3985 - 1i);
} else {
phi_6779_ = _e4085;
}
let _e4089 = phi_6779_;
let _e4091 = ((_e4089 - _e4053) * _e3980);
let _e4092 = (_e4068 + 1i);
let _e4094 = select(_e4092, 0i, (_e4092 < 0i));
if (_e4094 >= _e3990) {
phi_6793_ = (_e3990 - 1i);
} else {
phi_6793_ = _e4094;
}
let _e4098 = phi_6793_;
let _e4105 = global_1.member.member_13.member_10;
let _e4106 = bitcast<i32>(_e4105);
let _e4111 = ((_e4106 + (((_e4068 * _e3985) + _e4053) * _e3980)) + _e4038);
let _e4113 = select(_e1321, _e4111, (_e4111 < _e1321));
let _e4118 = global_8.member[bitcast<u32>(select(0i, _e4113, (_e4113 > 0i)))];
let _e4119 = local_2;
let _e4122 = local_3;
let _e4123 = (_e4111 + _e4122);
let _e4125 = select(_e1321, _e4123, (_e4123 < _e1321));
let _e4130 = global_8.member[bitcast<u32>(select(0i, _e4125, (_e4125 > 0i)))];
let _e4131 = local_2;
let _e4134 = (1f - _e4072);
let _e4136 = (_e4111 + _e4091);
let _e4138 = select(_e1321, _e4136, (_e4136 < _e1321));
let _e4143 = global_8.member[bitcast<u32>(select(0i, _e4138, (_e4138 > 0i)))];
let _e4144 = local_2;
let _e4147 = local_3;
let _e4148 = (_e4136 + _e4147);
let _e4150 = select(_e1321, _e4148, (_e4148 < _e1321));
let _e4155 = global_8.member[bitcast<u32>(select(0i, _e4150, (_e4150 > 0i)))];
let _e4156 = local_2;
let _e4161 = (_e4111 + (((_e4098 - _e4068) * _e3980) * _e3985));
let _e4163 = select(_e1321, _e4161, (_e4161 < _e1321));
let _e4168 = global_8.member[bitcast<u32>(select(0i, _e4163, (_e4163 > 0i)))];
let _e4169 = local_2;
let _e4172 = local_3;
let _e4173 = (_e4161 + _e4172);
let _e4175 = select(_e1321, _e4173, (_e4173 < _e1321));
let _e4180 = global_8.member[bitcast<u32>(select(0i, _e4175, (_e4175 > 0i)))];
let _e4181 = local_2;
let _e4185 = (_e4161 + _e4091);
let _e4187 = select(_e1321, _e4185, (_e4185 < _e1321));
let _e4192 = global_8.member[bitcast<u32>(select(0i, _e4187, (_e4187 > 0i)))];
let _e4193 = local_2;
let _e4196 = local_3;
let _e4197 = (_e4185 + _e4196);
let _e4199 = select(_e1321, _e4197, (_e4197 < _e1321));
let _e4204 = global_8.member[bitcast<u32>(select(0i, _e4199, (_e4199 > 0i)))];
let _e4205 = local_2;
let _e4214 = (_e3966 + _e3968);
let _e4224 = (((((_e817 + (_e500 * _e4214)) - _e3896.member) / _e3993) * _e3991) - 0.5f);
let _e4226 = select(0f, _e4224, (_e4224 > 0f));
let _e4228 = select(_e3997, _e4226, (_e4226 < _e3997));
let _e4232 = (((((_e818 + (_e511 * _e4214)) - _e3896.member_1) / _e4004) * _e4002) - 0.5f);
let _e4234 = select(0f, _e4232, (_e4232 > 0f));
let _e4236 = select(_e4008, _e4234, (_e4234 < _e4008));
let _e4240 = (((((_e819 + (_e522 * _e4214)) - _e3896.member_2) / _e4015) * _e4013) - 0.5f);
let _e4242 = select(0f, _e4240, (_e4240 > 0f));
let _e4244 = select(_e4019, _e4242, (_e4242 < _e4019));
let _e4246 = select(0f, _e4228, (_e4228 > 0f));
let _e4248 = select(1e6f, _e4246, (_e4246 < 1e6f));
let _e4255 = select(0i, select(select(i32(_e4248), i32(-2147483648), (_e4248 < -2147483600f)), 2147483647i, (_e4248 > 2147483500f)), (_e4248 == _e4248));
let _e4259 = (_e4255 - select(0i, 1i, (_e4248 < f32(_e4255))));
let _e4261 = select(0f, _e4236, (_e4236 > 0f));
let _e4263 = select(1e6f, _e4261, (_e4261 < 1e6f));
let _e4270 = select(0i, select(select(i32(_e4263), i32(-2147483648), (_e4263 < -2147483600f)), 2147483647i, (_e4263 > 2147483500f)), (_e4263 == _e4263));
let _e4274 = (_e4270 - select(0i, 1i, (_e4263 < f32(_e4270))));
let _e4276 = select(0f, _e4244, (_e4244 > 0f));
let _e4278 = select(1e6f, _e4276, (_e4276 < 1e6f));
let _e4285 = select(0i, select(select(i32(_e4278), i32(-2147483648), (_e4278 < -2147483600f)), 2147483647i, (_e4278 > 2147483500f)), (_e4278 == _e4278));
let _e4289 = (_e4285 - select(0i, 1i, (_e4278 < f32(_e4285))));
let _e4293 = (_e4236 - f32(_e4274));
let _e4295 = (_e4244 - f32(_e4289));
local = (_e4228 - f32(_e4259));
let _e4296 = (_e4259 + 1i);
let _e4298 = select(_e4296, 0i, (_e4296 < 0i));
if (_e4298 >= _e3980) {
phi_7109_ = (_e3980 - 1i);
} else {
phi_7109_ = _e4298;
}
let _e4302 = phi_7109_;
local_1 = (_e4302 - _e4259);
let _e4304 = (_e4274 + 1i);
let _e4306 = select(_e4304, 0i, (_e4304 < 0i));
if (_e4306 >= _e3985) {
phi_7122_ = (_e3985 - 1i);
} else {
phi_7122_ = _e4306;
}
let _e4310 = phi_7122_;
let _e4312 = ((_e4310 - _e4274) * _e3980);
let _e4313 = (_e4289 + 1i);
let _e4315 = select(_e4313, 0i, (_e4313 < 0i));
if (_e4315 >= _e3990) {
phi_7136_ = (_e3990 - 1i);
} else {
phi_7136_ = _e4315;
}
let _e4319 = phi_7136_;
let _e4327 = ((_e4106 + (((_e4289 * _e3985) + _e4274) * _e3980)) + _e4259);
let _e4329 = select(_e1321, _e4327, (_e4327 < _e1321));
let _e4334 = global_8.member[bitcast<u32>(select(0i, _e4329, (_e4329 > 0i)))];
let _e4335 = local;
let _e4338 = local_1;
let _e4339 = (_e4327 + _e4338);
let _e4341 = select(_e1321, _e4339, (_e4339 < _e1321));
let _e4346 = global_8.member[bitcast<u32>(select(0i, _e4341, (_e4341 > 0i)))];
let _e4347 = local;
let _e4350 = (1f - _e4293);
let _e4352 = (_e4327 + _e4312);
let _e4354 = select(_e1321, _e4352, (_e4352 < _e1321));
let _e4359 = global_8.member[bitcast<u32>(select(0i, _e4354, (_e4354 > 0i)))];
let _e4360 = local;
let _e4363 = local_1;
let _e4364 = (_e4352 + _e4363);
let _e4366 = select(_e1321, _e4364, (_e4364 < _e1321));
let _e4371 = global_8.member[bitcast<u32>(select(0i, _e4366, (_e4366 > 0i)))];
let _e4372 = local;
let _e4377 = (_e4327 + (((_e4319 - _e4289) * _e3980) * _e3985));
let _e4379 = select(_e1321, _e4377, (_e4377 < _e1321));
let _e4384 = global_8.member[bitcast<u32>(select(0i, _e4379, (_e4379 > 0i)))];
let _e4385 = local;
let _e4388 = local_1;
let _e4389 = (_e4377 + _e4388);
let _e4391 = select(_e1321, _e4389, (_e4389 < _e1321));
let _e4396 = global_8.member[bitcast<u32>(select(0i, _e4391, (_e4391 > 0i)))];
let _e4397 = local;
let _e4401 = (_e4377 + _e4312);
let _e4403 = select(_e1321, _e4401, (_e4401 < _e1321));
let _e4408 = global_8.member[bitcast<u32>(select(0i, _e4403, (_e4403 > 0i)))];
let _e4409 = local;
let _e4412 = local_1;
let _e4413 = (_e4401 + _e4412);
let _e4415 = select(_e1321, _e4413, (_e4413 < _e1321));
let _e4420 = global_8.member[bitcast<u32>(select(0i, _e4415, (_e4415 > 0i)))];
let _e4421 = local;
phi_6629_ = (_e3955 + 1u);
phi_6632_ = (_e3957 + ((0.5f * (((((((_e4118 * (1f - _e4119)) + (_e4130 * _e4131)) * _e4134) + (((_e4143 * (1f - _e4144)) + (_e4155 * _e4156)) * _e4072)) * (1f - _e4074)) + (((((_e4168 * (1f - _e4169)) + (_e4180 * _e4181)) * _e4134) + (((_e4192 * (1f - _e4193)) + (_e4204 * _e4205)) * _e4072)) * _e4074)) + ((((((_e4334 * (1f - _e4335)) + (_e4346 * _e4347)) * _e4350) + (((_e4359 * (1f - _e4360)) + (_e4371 * _e4372)) * _e4293)) * (1f - _e4295)) + (((((_e4384 * (1f - _e4385)) + (_e4396 * _e4397)) * _e4350) + (((_e4408 * (1f - _e4409)) + (_e4420 * _e4421)) * _e4293)) * _e4295)))) * _e3967));
} else {
phi_6629_ = u32();
phi_6632_ = f32();
}
let _e4436 = phi_6629_;
let _e4438 = phi_6632_;
continue;
continuing {
phi_6628_ = _e4436;
phi_6631_ = _e4438;
break if !(_e3960);
}
}
let _e4781 = local_43;
phi_7341_ = _e4781;
}
let _e4441 = phi_7341_;
let _e4445 = global_1.member.member_13.member;
let _e4450 = -((_e4445.member * _e4441));
let _e4452 = select(-87f, _e4450, (_e4450 > -87f));
let _e4454 = select(88f, _e4452, (_e4452 < 88f));
let _e4456 = ((_e4454 * 1.442695f) + 0.5f);
let _e4458 = select(-127f, _e4456, (_e4456 > -127f));
let _e4460 = select(128f, _e4458, (_e4458 < 128f));
let _e4467 = select(0i, select(select(i32(_e4460), i32(-2147483648), (_e4460 < -2147483600f)), 2147483647i, (_e4460 > 2147483500f)), (_e4460 == _e4460));
let _e4471 = (_e4467 - select(0i, 1i, (_e4460 < f32(_e4467))));
let _e4472 = f32(_e4471);
let _e4476 = ((_e4454 - (_e4472 * 0.6933594f)) - (_e4472 * -2.1219444e-4f));
let _e4498 = -((_e4445.member_1 * _e4441));
let _e4500 = select(-87f, _e4498, (_e4498 > -87f));
let _e4502 = select(88f, _e4500, (_e4500 < 88f));
let _e4504 = ((_e4502 * 1.442695f) + 0.5f);
let _e4506 = select(-127f, _e4504, (_e4504 > -127f));
let _e4508 = select(128f, _e4506, (_e4506 < 128f));
let _e4515 = select(0i, select(select(i32(_e4508), i32(-2147483648), (_e4508 < -2147483600f)), 2147483647i, (_e4508 > 2147483500f)), (_e4508 == _e4508));
let _e4519 = (_e4515 - select(0i, 1i, (_e4508 < f32(_e4515))));
let _e4520 = f32(_e4519);
let _e4524 = ((_e4502 - (_e4520 * 0.6933594f)) - (_e4520 * -2.1219444e-4f));
let _e4546 = -((_e4445.member_2 * _e4441));
let _e4548 = select(-87f, _e4546, (_e4546 > -87f));
let _e4550 = select(88f, _e4548, (_e4548 < 88f));
let _e4552 = ((_e4550 * 1.442695f) + 0.5f);
let _e4554 = select(-127f, _e4552, (_e4552 > -127f));
let _e4556 = select(128f, _e4554, (_e4554 < 128f));
let _e4563 = select(0i, select(select(i32(_e4556), i32(-2147483648), (_e4556 < -2147483600f)), 2147483647i, (_e4556 > 2147483500f)), (_e4556 == _e4556));
let _e4567 = (_e4563 - select(0i, 1i, (_e4556 < f32(_e4563))));
let _e4568 = f32(_e4567);
let _e4572 = ((_e4550 - (_e4568 * 0.6933594f)) - (_e4568 * -2.1219444e-4f));
let _e4595 = local_36;
let _e4600 = local_37;
let _e4605 = local_38;
phi_7580_ = array<f32, 22>(_e174, _e184, _e195, (_e206 + (((_e4595.x * _e1298.member_3.x) * ((1f + (_e4476 * (1f + (_e4476 * (0.5f + (_e4476 * (0.16666667f + (_e4476 * (0.041666668f + (_e4476 * (0.008333334f + (_e4476 * (0.001388889f + (_e4476 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4471 + 127i)) << bitcast<u32>(23i))))) * select(_e665, 1f, _e735))), (_e217 + (((_e4600.y * _e1298.member_3.y) * ((1f + (_e4524 * (1f + (_e4524 * (0.5f + (_e4524 * (0.16666667f + (_e4524 * (0.041666668f + (_e4524 * (0.008333334f + (_e4524 * (0.001388889f + (_e4524 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4519 + 127i)) << bitcast<u32>(23i))))) * select(_e676, 1f, _e735))), (_e228 + (((_e4605.z * _e1298.member_3.z) * ((1f + (_e4572 * (1f + (_e4572 * (0.5f + (_e4572 * (0.16666667f + (_e4572 * (0.041666668f + (_e4572 * (0.008333334f + (_e4572 * (0.001388889f + (_e4572 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4567 + 127i)) << bitcast<u32>(23i))))) * select(_e687, 1f, _e735))), _e239, _e250, _e261, _e272, _e283, _e294, _e305, _e316, _e327, _e338, _e349, _e360, _e371, _e382, _e393, _e404);
} else {
phi_7580_ = array<f32, 22>(_e174, _e184, _e195, _e206, _e217, _e228, _e239, _e250, _e261, _e272, _e283, _e294, _e305, _e316, _e327, _e338, _e349, _e360, _e371, _e382, _e393, _e404);
}
let _e4620 = phi_7580_;
global_5.member[_e163] = _e4620[0];
global_5.member[_e175] = _e4620[1];
global_5.member[_e186] = _e4620[2];
global_5.member[_e197] = _e4620[3];
global_5.member[_e208] = _e4620[4];
global_5.member[_e219] = _e4620[5];
global_5.member[_e230] = _e4620[6];
global_5.member[_e241] = _e4620[7];
global_5.member[_e252] = _e4620[8];
global_5.member[_e263] = _e4620[9];
global_5.member[_e274] = _e4620[10];
global_5.member[_e285] = _e4620[11];
global_5.member[_e296] = _e4620[12];
global_5.member[_e307] = _e4620[13];
global_5.member[_e318] = _e4620[14];
global_5.member[_e329] = _e4620[15];
global_5.member[_e340] = _e4620[16];
global_5.member[_e351] = _e4620[17];
global_5.member[_e362] = _e4620[18];
global_5.member[_e373] = _e4620[19];
global_5.member[_e384] = _e4620[20];
global_5.member[_e395] = _e4620[21];
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
