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
struct type_16 {
member: u32,
member_1: u32,
}
struct type_17 {
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
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
}
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_20 {
member: f32,
member_1: u32,
}
struct type_21 {
member: type_2,
member_1: type_16,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_20,
}
struct type_22 {
member: type_21,
}
struct type_24 {
member: array<u32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_13;
@group(0) @binding(0)
var<storage> global_2: type_22;
@group(0) @binding(1)
var<storage> global_3: type_13;
@group(0) @binding(2)
var<storage> global_4: type_24;
@group(0) @binding(3)
var<storage> global_5: type_24;
fn function_() {
var phi_616_: u32;
var phi_622_: u32;
var phi_684_: u32;
var phi_690_: u32;
var phi_752_: u32;
var phi_758_: u32;
var phi_781_: vec3<f32>;
var phi_784_: u32;
var phi_904_: u32;
var phi_907_: u32;
var phi_905_: u32;
var phi_908_: u32;
var local: u32;
var phi_988_: u32;
var phi_994_: u32;
var phi_1056_: u32;
var phi_1062_: u32;
var phi_1124_: u32;
var phi_1130_: u32;
var phi_1203_: u32;
var phi_1206_: u32;
var phi_1204_: u32;
var phi_1207_: u32;
var local_1: u32;
var phi_1287_: u32;
var phi_1293_: u32;
var phi_1355_: u32;
var phi_1361_: u32;
var phi_1423_: u32;
var phi_1429_: u32;
var phi_1504_: u32;
var phi_1507_: u32;
var phi_1505_: u32;
var phi_1508_: u32;
var local_2: u32;
var phi_1588_: u32;
var phi_1594_: u32;
var phi_1656_: u32;
var phi_1662_: u32;
var phi_1724_: u32;
var phi_1730_: u32;
var phi_1804_: u32;
var phi_1807_: u32;
var phi_1805_: u32;
var phi_1808_: u32;
var local_3: u32;
var phi_1888_: u32;
var phi_1894_: u32;
var phi_1956_: u32;
var phi_1962_: u32;
var phi_2024_: u32;
var phi_2030_: u32;
var phi_782_: vec3<f32>;
var phi_785_: u32;
var local_4: vec3<f32>;
var local_5: vec3<f32>;
var local_6: vec3<f32>;
var phi_2223_: u32;
var phi_2229_: u32;
var phi_2291_: u32;
var phi_2297_: u32;
var phi_2359_: u32;
var phi_2365_: u32;
var phi_2388_: vec3<f32>;
var phi_2391_: u32;
var local_7: u32;
var phi_2511_: u32;
var phi_2514_: u32;
var phi_2512_: u32;
var phi_2515_: u32;
var local_8: u32;
var phi_2595_: u32;
var phi_2601_: u32;
var phi_2663_: u32;
var phi_2669_: u32;
var phi_2731_: u32;
var phi_2737_: u32;
var phi_2810_: u32;
var phi_2813_: u32;
var phi_2811_: u32;
var phi_2814_: u32;
var local_9: u32;
var phi_2894_: u32;
var phi_2900_: u32;
var phi_2962_: u32;
var phi_2968_: u32;
var phi_3030_: u32;
var phi_3036_: u32;
var phi_3111_: u32;
var phi_3114_: u32;
var phi_3112_: u32;
var phi_3115_: u32;
var local_10: u32;
var phi_3195_: u32;
var phi_3201_: u32;
var phi_3263_: u32;
var phi_3269_: u32;
var phi_3331_: u32;
var phi_3337_: u32;
var phi_3411_: u32;
var phi_3414_: u32;
var phi_3412_: u32;
var phi_3415_: u32;
var local_11: u32;
var phi_3495_: u32;
var phi_3501_: u32;
var phi_3563_: u32;
var phi_3569_: u32;
var phi_3631_: u32;
var phi_3637_: u32;
var phi_2389_: vec3<f32>;
var phi_2392_: u32;
var local_12: vec3<f32>;
var local_13: vec3<f32>;
var local_14: vec3<f32>;
let _e53 = global;
let _e62 = global_2.member.member;
if (_e53.x < _e62.member) {
if (_e53.y < _e62.member_1) {
let _e69 = (_e62.member * _e62.member_1);
let _e71 = ((_e53.y * _e62.member) + _e53.x);
let _e75 = global_2.member.member.member;
let _e79 = global_2.member.member.member_1;
let _e80 = (_e75 * _e79);
let _e82 = ((_e53.y * _e75) + _e53.x);
let _e83 = bitcast<i32>(_e82);
let _e85 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e87 = select(_e85, _e83, (_e83 < _e85));
let _e93 = global_3.member[bitcast<u32>(select(0i, _e87, (_e87 > 0i)))];
let _e96 = bitcast<i32>(((2u * _e80) + _e82));
let _e98 = select(_e85, _e96, (_e96 < _e85));
let _e104 = global_3.member[bitcast<u32>(select(0i, _e98, (_e98 > 0i)))];
let _e107 = bitcast<i32>(((3u * _e80) + _e82));
let _e109 = select(_e85, _e107, (_e107 < _e85));
let _e115 = global_3.member[bitcast<u32>(select(0i, _e109, (_e109 > 0i)))];
let _e118 = bitcast<i32>(((4u * _e80) + _e82));
let _e120 = select(_e85, _e118, (_e118 < _e85));
let _e126 = global_3.member[bitcast<u32>(select(0i, _e120, (_e120 > 0i)))];
let _e129 = bitcast<i32>(((5u * _e80) + _e82));
let _e131 = select(_e85, _e129, (_e129 < _e85));
let _e137 = global_3.member[bitcast<u32>(select(0i, _e131, (_e131 > 0i)))];
let _e140 = bitcast<i32>(((6u * _e80) + _e82));
let _e142 = select(_e85, _e140, (_e140 < _e85));
let _e148 = global_3.member[bitcast<u32>(select(0i, _e142, (_e142 > 0i)))];
let _e151 = bitcast<i32>(((7u * _e80) + _e82));
let _e153 = select(_e85, _e151, (_e151 < _e85));
let _e159 = global_3.member[bitcast<u32>(select(0i, _e153, (_e153 > 0i)))];
let _e162 = bitcast<i32>(((8u * _e80) + _e82));
let _e164 = select(_e85, _e162, (_e162 < _e85));
let _e170 = global_3.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e173 = bitcast<i32>(((9u * _e80) + _e82));
let _e175 = select(_e85, _e173, (_e173 < _e85));
let _e181 = global_3.member[bitcast<u32>(select(0i, _e175, (_e175 > 0i)))];
let _e184 = bitcast<i32>(((10u * _e80) + _e82));
let _e186 = select(_e85, _e184, (_e184 < _e85));
let _e192 = global_3.member[bitcast<u32>(select(0i, _e186, (_e186 > 0i)))];
let _e195 = bitcast<i32>(((11u * _e80) + _e82));
let _e197 = select(_e85, _e195, (_e195 < _e85));
let _e203 = global_3.member[bitcast<u32>(select(0i, _e197, (_e197 > 0i)))];
let _e206 = bitcast<i32>(((12u * _e80) + _e82));
let _e208 = select(_e85, _e206, (_e206 < _e85));
let _e214 = global_3.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e217 = bitcast<i32>(((13u * _e80) + _e82));
let _e219 = select(_e85, _e217, (_e217 < _e85));
let _e225 = global_3.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e228 = bitcast<i32>(((14u * _e80) + _e82));
let _e230 = select(_e85, _e228, (_e228 < _e85));
let _e236 = global_3.member[bitcast<u32>(select(0i, _e230, (_e230 > 0i)))];
let _e239 = bitcast<i32>(((15u * _e80) + _e82));
let _e241 = select(_e85, _e239, (_e239 < _e85));
let _e247 = global_3.member[bitcast<u32>(select(0i, _e241, (_e241 > 0i)))];
let _e250 = bitcast<i32>(((16u * _e80) + _e82));
let _e252 = select(_e85, _e250, (_e250 < _e85));
let _e258 = global_3.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e261 = bitcast<i32>(((17u * _e80) + _e82));
let _e263 = select(_e85, _e261, (_e261 < _e85));
let _e269 = global_3.member[bitcast<u32>(select(0i, _e263, (_e263 > 0i)))];
let _e270 = bitcast<i32>(_e53.x);
let _e271 = bitcast<i32>(_e53.y);
let _e275 = global_2.member.member_1.member;
let _e279 = global_2.member.member_1.member_1;
let _e280 = bitcast<i32>(_e275);
let _e281 = (_e280 - 1i);
let _e282 = bitcast<i32>(_e279);
let _e283 = (_e282 - 1i);
let _e285 = select(_e281, _e270, (_e270 < _e281));
let _e287 = select(_e283, _e271, (_e271 < _e283));
let _e294 = (((select(0i, _e287, (_e287 > 0i)) * _e280) + select(0i, _e285, (_e285 > 0i))) * 6i);
let _e296 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e298 = select(_e296, _e294, (_e294 < _e296));
let _e304 = global_4.member[bitcast<u32>(select(0i, _e298, (_e298 > 0i)))];
let _e305 = (_e294 + 1i);
let _e307 = select(_e296, _e305, (_e305 < _e296));
let _e313 = global_4.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e316 = ((_e313 >> bitcast<u32>(31i)) != 0u);
if _e316 {
phi_616_ = (~(_e304) + 1u);
} else {
phi_616_ = _e304;
}
let _e322 = phi_616_;
if _e316 {
phi_622_ = (~(_e313) + select(0u, 1u, (_e304 == 0u)));
} else {
phi_622_ = _e313;
}
let _e326 = phi_622_;
let _e348 = ((((f32(bitcast<i32>(((_e326 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e326 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e322 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e322 & 65535u)))));
let _e354 = (_e294 + 2i);
let _e356 = select(_e296, _e354, (_e354 < _e296));
let _e362 = global_4.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e363 = (_e294 + 3i);
let _e365 = select(_e296, _e363, (_e363 < _e296));
let _e371 = global_4.member[bitcast<u32>(select(0i, _e365, (_e365 > 0i)))];
let _e374 = ((_e371 >> bitcast<u32>(31i)) != 0u);
if _e374 {
phi_684_ = (~(_e362) + 1u);
} else {
phi_684_ = _e362;
}
let _e380 = phi_684_;
if _e374 {
phi_690_ = (~(_e371) + select(0u, 1u, (_e362 == 0u)));
} else {
phi_690_ = _e371;
}
let _e384 = phi_690_;
let _e406 = ((((f32(bitcast<i32>(((_e384 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e384 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e380 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e380 & 65535u)))));
let _e412 = (_e294 + 4i);
let _e414 = select(_e296, _e412, (_e412 < _e296));
let _e420 = global_4.member[bitcast<u32>(select(0i, _e414, (_e414 > 0i)))];
let _e421 = (_e294 + 5i);
let _e423 = select(_e296, _e421, (_e421 < _e296));
let _e429 = global_4.member[bitcast<u32>(select(0i, _e423, (_e423 > 0i)))];
let _e432 = ((_e429 >> bitcast<u32>(31i)) != 0u);
if _e432 {
phi_752_ = (~(_e420) + 1u);
} else {
phi_752_ = _e420;
}
let _e438 = phi_752_;
if _e432 {
phi_758_ = (~(_e429) + select(0u, 1u, (_e420 == 0u)));
} else {
phi_758_ = _e429;
}
let _e442 = phi_758_;
let _e464 = ((((f32(bitcast<i32>(((_e442 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e442 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e438 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e438 & 65535u)))));
phi_781_ = vec3<f32>(select(_e348, -(bitcast<f32>((bitcast<u32>(_e348) & 2147483647u))), _e316), select(_e406, -(bitcast<f32>((bitcast<u32>(_e406) & 2147483647u))), _e374), select(_e464, -(bitcast<f32>((bitcast<u32>(_e464) & 2147483647u))), _e432));
phi_784_ = 1u;
loop {
let _e472 = phi_781_;
let _e474 = phi_784_;
local_4 = _e472;
local_5 = _e472;
local_6 = _e472;
let _e478 = global_2.member.member_18.member_1;
let _e479 = (_e474 <= _e478);
local_7 = _e478;
if _e479 {
let _e480 = (_e474 & 31u);
let _e484 = (1f / f32((1i << bitcast<u32>(_e480))));
let _e488 = (((f32(_e270) + 0.5f) * _e484) - 0.5f);
let _e492 = (((f32(_e271) + 0.5f) * _e484) - 0.5f);
let _e494 = select(-1f, _e488, (_e488 > -1f));
let _e496 = select(1e6f, _e494, (_e494 < 1e6f));
let _e503 = select(0i, select(select(i32(_e496), i32(-2147483648), (_e496 < -2147483600f)), 2147483647i, (_e496 > 2147483500f)), (_e496 == _e496));
let _e507 = (_e503 - select(0i, 1i, (_e496 < f32(_e503))));
let _e509 = select(-1f, _e492, (_e492 > -1f));
let _e511 = select(1e6f, _e509, (_e509 < 1e6f));
let _e518 = select(0i, select(select(i32(_e511), i32(-2147483648), (_e511 < -2147483600f)), 2147483647i, (_e511 > 2147483500f)), (_e511 == _e511));
let _e522 = (_e518 - select(0i, 1i, (_e511 < f32(_e518))));
let _e524 = (_e488 - f32(_e507));
let _e526 = (_e492 - f32(_e522));
let _e528 = (1u << bitcast<u32>(_e480));
let _e537 = bitcast<i32>((((_e275 + _e528) - 1u) >> bitcast<u32>(_e480)));
let _e538 = (_e537 - 1i);
let _e540 = (bitcast<i32>((((_e279 + _e528) - 1u) >> bitcast<u32>(_e480))) - 1i);
let _e542 = select(_e538, _e507, (_e507 < _e538));
let _e544 = select(_e540, _e522, (_e522 < _e540));
let _e546 = select(0i, _e542, (_e542 > 0i));
phi_904_ = 0u;
phi_907_ = 0u;
loop {
let _e550 = phi_904_;
let _e552 = phi_907_;
local = _e552;
let _e553 = (_e550 < _e474);
if _e553 {
let _e554 = (_e550 & 31u);
let _e556 = (1u << bitcast<u32>(_e554));
phi_905_ = (_e550 + 1u);
phi_908_ = (_e552 + ((((_e275 + _e556) - 1u) >> bitcast<u32>(_e554)) * (((_e279 + _e556) - 1u) >> bitcast<u32>(_e554))));
} else {
phi_905_ = u32();
phi_908_ = u32();
}
let _e569 = phi_905_;
let _e571 = phi_908_;
continue;
continuing {
phi_904_ = _e569;
phi_907_ = _e571;
break if !(_e553);
}
}
let _e574 = local;
let _e576 = (select(0i, _e544, (_e544 > 0i)) * _e537);
let _e579 = (((bitcast<i32>(_e574) + _e576) + _e546) * 6i);
let _e581 = select(_e296, _e579, (_e579 < _e296));
let _e587 = global_4.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e588 = (_e579 + 1i);
let _e590 = select(_e296, _e588, (_e588 < _e296));
let _e596 = global_4.member[bitcast<u32>(select(0i, _e590, (_e590 > 0i)))];
let _e599 = ((_e596 >> bitcast<u32>(31i)) != 0u);
if _e599 {
phi_988_ = (~(_e587) + 1u);
} else {
phi_988_ = _e587;
}
let _e605 = phi_988_;
if _e599 {
phi_994_ = (~(_e596) + select(0u, 1u, (_e587 == 0u)));
} else {
phi_994_ = _e596;
}
let _e609 = phi_994_;
let _e631 = ((((f32(bitcast<i32>(((_e609 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e609 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e605 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e605 & 65535u)))));
let _e637 = (_e579 + 2i);
let _e639 = select(_e296, _e637, (_e637 < _e296));
let _e645 = global_4.member[bitcast<u32>(select(0i, _e639, (_e639 > 0i)))];
let _e646 = (_e579 + 3i);
let _e648 = select(_e296, _e646, (_e646 < _e296));
let _e654 = global_4.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e657 = ((_e654 >> bitcast<u32>(31i)) != 0u);
if _e657 {
phi_1056_ = (~(_e645) + 1u);
} else {
phi_1056_ = _e645;
}
let _e663 = phi_1056_;
if _e657 {
phi_1062_ = (~(_e654) + select(0u, 1u, (_e645 == 0u)));
} else {
phi_1062_ = _e654;
}
let _e667 = phi_1062_;
let _e689 = ((((f32(bitcast<i32>(((_e667 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e667 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e663 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e663 & 65535u)))));
let _e695 = (_e579 + 4i);
let _e697 = select(_e296, _e695, (_e695 < _e296));
let _e703 = global_4.member[bitcast<u32>(select(0i, _e697, (_e697 > 0i)))];
let _e704 = (_e579 + 5i);
let _e706 = select(_e296, _e704, (_e704 < _e296));
let _e712 = global_4.member[bitcast<u32>(select(0i, _e706, (_e706 > 0i)))];
let _e715 = ((_e712 >> bitcast<u32>(31i)) != 0u);
if _e715 {
phi_1124_ = (~(_e703) + 1u);
} else {
phi_1124_ = _e703;
}
let _e721 = phi_1124_;
if _e715 {
phi_1130_ = (~(_e712) + select(0u, 1u, (_e703 == 0u)));
} else {
phi_1130_ = _e712;
}
let _e725 = phi_1130_;
let _e747 = ((((f32(bitcast<i32>(((_e725 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e725 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e721 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e721 & 65535u)))));
let _e753 = (1f - _e524);
let _e757 = (_e507 + 1i);
let _e759 = select(_e538, _e757, (_e757 < _e538));
let _e761 = select(0i, _e759, (_e759 > 0i));
phi_1203_ = 0u;
phi_1206_ = 0u;
loop {
let _e763 = phi_1203_;
let _e765 = phi_1206_;
local_1 = _e765;
let _e766 = (_e763 < _e474);
if _e766 {
let _e767 = (_e763 & 31u);
let _e769 = (1u << bitcast<u32>(_e767));
phi_1204_ = (_e763 + 1u);
phi_1207_ = (_e765 + ((((_e275 + _e769) - 1u) >> bitcast<u32>(_e767)) * (((_e279 + _e769) - 1u) >> bitcast<u32>(_e767))));
} else {
phi_1204_ = u32();
phi_1207_ = u32();
}
let _e782 = phi_1204_;
let _e784 = phi_1207_;
continue;
continuing {
phi_1203_ = _e782;
phi_1206_ = _e784;
break if !(_e766);
}
}
let _e787 = local_1;
let _e791 = (((bitcast<i32>(_e787) + _e576) + _e761) * 6i);
let _e793 = select(_e296, _e791, (_e791 < _e296));
let _e799 = global_4.member[bitcast<u32>(select(0i, _e793, (_e793 > 0i)))];
let _e800 = (_e791 + 1i);
let _e802 = select(_e296, _e800, (_e800 < _e296));
let _e808 = global_4.member[bitcast<u32>(select(0i, _e802, (_e802 > 0i)))];
let _e811 = ((_e808 >> bitcast<u32>(31i)) != 0u);
if _e811 {
phi_1287_ = (~(_e799) + 1u);
} else {
phi_1287_ = _e799;
}
let _e817 = phi_1287_;
if _e811 {
phi_1293_ = (~(_e808) + select(0u, 1u, (_e799 == 0u)));
} else {
phi_1293_ = _e808;
}
let _e821 = phi_1293_;
let _e843 = ((((f32(bitcast<i32>(((_e821 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e821 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e817 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e817 & 65535u)))));
let _e849 = (_e791 + 2i);
let _e851 = select(_e296, _e849, (_e849 < _e296));
let _e857 = global_4.member[bitcast<u32>(select(0i, _e851, (_e851 > 0i)))];
let _e858 = (_e791 + 3i);
let _e860 = select(_e296, _e858, (_e858 < _e296));
let _e866 = global_4.member[bitcast<u32>(select(0i, _e860, (_e860 > 0i)))];
let _e869 = ((_e866 >> bitcast<u32>(31i)) != 0u);
if _e869 {
phi_1355_ = (~(_e857) + 1u);
} else {
phi_1355_ = _e857;
}
let _e875 = phi_1355_;
if _e869 {
phi_1361_ = (~(_e866) + select(0u, 1u, (_e857 == 0u)));
} else {
phi_1361_ = _e866;
}
let _e879 = phi_1361_;
let _e901 = ((((f32(bitcast<i32>(((_e879 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e879 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e875 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e875 & 65535u)))));
let _e907 = (_e791 + 4i);
let _e909 = select(_e296, _e907, (_e907 < _e296));
let _e915 = global_4.member[bitcast<u32>(select(0i, _e909, (_e909 > 0i)))];
let _e916 = (_e791 + 5i);
let _e918 = select(_e296, _e916, (_e916 < _e296));
let _e924 = global_4.member[bitcast<u32>(select(0i, _e918, (_e918 > 0i)))];
let _e927 = ((_e924 >> bitcast<u32>(31i)) != 0u);
if _e927 {
phi_1423_ = (~(_e915) + 1u);
} else {
phi_1423_ = _e915;
}
let _e933 = phi_1423_;
if _e927 {
phi_1429_ = (~(_e924) + select(0u, 1u, (_e915 == 0u)));
} else {
phi_1429_ = _e924;
}
let _e937 = phi_1429_;
let _e959 = ((((f32(bitcast<i32>(((_e937 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e937 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e933 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e933 & 65535u)))));
let _e971 = (_e522 + 1i);
let _e973 = select(_e540, _e971, (_e971 < _e540));
phi_1504_ = 0u;
phi_1507_ = 0u;
loop {
let _e977 = phi_1504_;
let _e979 = phi_1507_;
local_2 = _e979;
let _e980 = (_e977 < _e474);
if _e980 {
let _e981 = (_e977 & 31u);
let _e983 = (1u << bitcast<u32>(_e981));
phi_1505_ = (_e977 + 1u);
phi_1508_ = (_e979 + ((((_e275 + _e983) - 1u) >> bitcast<u32>(_e981)) * (((_e279 + _e983) - 1u) >> bitcast<u32>(_e981))));
} else {
phi_1505_ = u32();
phi_1508_ = u32();
}
let _e996 = phi_1505_;
let _e998 = phi_1508_;
continue;
continuing {
phi_1504_ = _e996;
phi_1507_ = _e998;
break if !(_e980);
}
}
let _e1001 = local_2;
let _e1003 = (select(0i, _e973, (_e973 > 0i)) * _e537);
let _e1006 = (((bitcast<i32>(_e1001) + _e1003) + _e546) * 6i);
let _e1008 = select(_e296, _e1006, (_e1006 < _e296));
let _e1014 = global_4.member[bitcast<u32>(select(0i, _e1008, (_e1008 > 0i)))];
let _e1015 = (_e1006 + 1i);
let _e1017 = select(_e296, _e1015, (_e1015 < _e296));
let _e1023 = global_4.member[bitcast<u32>(select(0i, _e1017, (_e1017 > 0i)))];
let _e1026 = ((_e1023 >> bitcast<u32>(31i)) != 0u);
if _e1026 {
phi_1588_ = (~(_e1014) + 1u);
} else {
phi_1588_ = _e1014;
}
let _e1032 = phi_1588_;
if _e1026 {
phi_1594_ = (~(_e1023) + select(0u, 1u, (_e1014 == 0u)));
} else {
phi_1594_ = _e1023;
}
let _e1036 = phi_1594_;
let _e1058 = ((((f32(bitcast<i32>(((_e1036 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1036 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1032 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1032 & 65535u)))));
let _e1064 = (_e1006 + 2i);
let _e1066 = select(_e296, _e1064, (_e1064 < _e296));
let _e1072 = global_4.member[bitcast<u32>(select(0i, _e1066, (_e1066 > 0i)))];
let _e1073 = (_e1006 + 3i);
let _e1075 = select(_e296, _e1073, (_e1073 < _e296));
let _e1081 = global_4.member[bitcast<u32>(select(0i, _e1075, (_e1075 > 0i)))];
let _e1084 = ((_e1081 >> bitcast<u32>(31i)) != 0u);
if _e1084 {
phi_1656_ = (~(_e1072) + 1u);
} else {
phi_1656_ = _e1072;
}
let _e1090 = phi_1656_;
if _e1084 {
phi_1662_ = (~(_e1081) + select(0u, 1u, (_e1072 == 0u)));
} else {
phi_1662_ = _e1081;
}
let _e1094 = phi_1662_;
let _e1116 = ((((f32(bitcast<i32>(((_e1094 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1094 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1090 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1090 & 65535u)))));
let _e1122 = (_e1006 + 4i);
let _e1124 = select(_e296, _e1122, (_e1122 < _e296));
let _e1130 = global_4.member[bitcast<u32>(select(0i, _e1124, (_e1124 > 0i)))];
let _e1131 = (_e1006 + 5i);
let _e1133 = select(_e296, _e1131, (_e1131 < _e296));
let _e1139 = global_4.member[bitcast<u32>(select(0i, _e1133, (_e1133 > 0i)))];
let _e1142 = ((_e1139 >> bitcast<u32>(31i)) != 0u);
if _e1142 {
phi_1724_ = (~(_e1130) + 1u);
} else {
phi_1724_ = _e1130;
}
let _e1148 = phi_1724_;
if _e1142 {
phi_1730_ = (~(_e1139) + select(0u, 1u, (_e1130 == 0u)));
} else {
phi_1730_ = _e1139;
}
let _e1152 = phi_1730_;
let _e1174 = ((((f32(bitcast<i32>(((_e1152 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1152 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1148 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1148 & 65535u)))));
phi_1804_ = 0u;
phi_1807_ = 0u;
loop {
let _e1184 = phi_1804_;
let _e1186 = phi_1807_;
local_3 = _e1186;
let _e1187 = (_e1184 < _e474);
if _e1187 {
let _e1188 = (_e1184 & 31u);
let _e1190 = (1u << bitcast<u32>(_e1188));
phi_1805_ = (_e1184 + 1u);
phi_1808_ = (_e1186 + ((((_e275 + _e1190) - 1u) >> bitcast<u32>(_e1188)) * (((_e279 + _e1190) - 1u) >> bitcast<u32>(_e1188))));
} else {
phi_1805_ = u32();
phi_1808_ = u32();
}
let _e1203 = phi_1805_;
let _e1205 = phi_1808_;
continue;
continuing {
phi_1804_ = _e1203;
phi_1807_ = _e1205;
break if !(_e1187);
}
}
let _e1208 = local_3;
let _e1212 = (((bitcast<i32>(_e1208) + _e1003) + _e761) * 6i);
let _e1214 = select(_e296, _e1212, (_e1212 < _e296));
let _e1220 = global_4.member[bitcast<u32>(select(0i, _e1214, (_e1214 > 0i)))];
let _e1221 = (_e1212 + 1i);
let _e1223 = select(_e296, _e1221, (_e1221 < _e296));
let _e1229 = global_4.member[bitcast<u32>(select(0i, _e1223, (_e1223 > 0i)))];
let _e1232 = ((_e1229 >> bitcast<u32>(31i)) != 0u);
if _e1232 {
phi_1888_ = (~(_e1220) + 1u);
} else {
phi_1888_ = _e1220;
}
let _e1238 = phi_1888_;
if _e1232 {
phi_1894_ = (~(_e1229) + select(0u, 1u, (_e1220 == 0u)));
} else {
phi_1894_ = _e1229;
}
let _e1242 = phi_1894_;
let _e1264 = ((((f32(bitcast<i32>(((_e1242 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1242 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1238 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1238 & 65535u)))));
let _e1270 = (_e1212 + 2i);
let _e1272 = select(_e296, _e1270, (_e1270 < _e296));
let _e1278 = global_4.member[bitcast<u32>(select(0i, _e1272, (_e1272 > 0i)))];
let _e1279 = (_e1212 + 3i);
let _e1281 = select(_e296, _e1279, (_e1279 < _e296));
let _e1287 = global_4.member[bitcast<u32>(select(0i, _e1281, (_e1281 > 0i)))];
let _e1290 = ((_e1287 >> bitcast<u32>(31i)) != 0u);
if _e1290 {
phi_1956_ = (~(_e1278) + 1u);
} else {
phi_1956_ = _e1278;
}
let _e1296 = phi_1956_;
if _e1290 {
phi_1962_ = (~(_e1287) + select(0u, 1u, (_e1278 == 0u)));
} else {
phi_1962_ = _e1287;
}
let _e1300 = phi_1962_;
let _e1322 = ((((f32(bitcast<i32>(((_e1300 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1300 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1296 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1296 & 65535u)))));
let _e1328 = (_e1212 + 4i);
let _e1330 = select(_e296, _e1328, (_e1328 < _e296));
let _e1336 = global_4.member[bitcast<u32>(select(0i, _e1330, (_e1330 > 0i)))];
let _e1337 = (_e1212 + 5i);
let _e1339 = select(_e296, _e1337, (_e1337 < _e296));
let _e1345 = global_4.member[bitcast<u32>(select(0i, _e1339, (_e1339 > 0i)))];
let _e1348 = ((_e1345 >> bitcast<u32>(31i)) != 0u);
if _e1348 {
phi_2024_ = (~(_e1336) + 1u);
} else {
phi_2024_ = _e1336;
}
let _e1354 = phi_2024_;
if _e1348 {
phi_2030_ = (~(_e1345) + select(0u, 1u, (_e1336 == 0u)));
} else {
phi_2030_ = _e1345;
}
let _e1358 = phi_2030_;
let _e1380 = ((((f32(bitcast<i32>(((_e1358 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1358 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1354 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1354 & 65535u)))));
let _e1392 = (1f - _e526);
phi_782_ = vec3<f32>((_e472.x + ((((select(_e631, -(bitcast<f32>((bitcast<u32>(_e631) & 2147483647u))), _e599) * _e753) + (select(_e843, -(bitcast<f32>((bitcast<u32>(_e843) & 2147483647u))), _e811) * _e524)) * _e1392) + (((select(_e1058, -(bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u))), _e1026) * _e753) + (select(_e1264, -(bitcast<f32>((bitcast<u32>(_e1264) & 2147483647u))), _e1232) * _e524)) * _e526))), (_e472.y + ((((select(_e689, -(bitcast<f32>((bitcast<u32>(_e689) & 2147483647u))), _e657) * _e753) + (select(_e901, -(bitcast<f32>((bitcast<u32>(_e901) & 2147483647u))), _e869) * _e524)) * _e1392) + (((select(_e1116, -(bitcast<f32>((bitcast<u32>(_e1116) & 2147483647u))), _e1084) * _e753) + (select(_e1322, -(bitcast<f32>((bitcast<u32>(_e1322) & 2147483647u))), _e1290) * _e524)) * _e526))), (_e472.z + ((((select(_e747, -(bitcast<f32>((bitcast<u32>(_e747) & 2147483647u))), _e715) * _e753) + (select(_e959, -(bitcast<f32>((bitcast<u32>(_e959) & 2147483647u))), _e927) * _e524)) * _e1392) + (((select(_e1174, -(bitcast<f32>((bitcast<u32>(_e1174) & 2147483647u))), _e1142) * _e753) + (select(_e1380, -(bitcast<f32>((bitcast<u32>(_e1380) & 2147483647u))), _e1348) * _e524)) * _e526))));
phi_785_ = (_e474 + 1u);
} else {
phi_782_ = vec3<f32>();
phi_785_ = u32();
}
let _e1411 = phi_782_;
let _e1413 = phi_785_;
continue;
continuing {
phi_781_ = _e1411;
phi_784_ = _e1413;
break if !(_e479);
}
}
let _e1418 = global_2.member.member_18.member;
let _e1419 = (1f / _e1418);
let _e1421 = local_4;
let _e1425 = local_5;
let _e1429 = local_6;
let _e1432 = ((_e1421.x * _e1419) + _e170);
let _e1433 = ((_e1425.y * _e1419) + _e181);
let _e1434 = ((_e1429.z * _e1419) + _e192);
let _e1436 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1438 = select(_e1436, _e294, (_e294 < _e1436));
let _e1444 = global_5.member[bitcast<u32>(select(0i, _e1438, (_e1438 > 0i)))];
let _e1446 = select(_e1436, _e305, (_e305 < _e1436));
let _e1452 = global_5.member[bitcast<u32>(select(0i, _e1446, (_e1446 > 0i)))];
let _e1455 = ((_e1452 >> bitcast<u32>(31i)) != 0u);
if _e1455 {
phi_2223_ = (~(_e1444) + 1u);
} else {
phi_2223_ = _e1444;
}
let _e1461 = phi_2223_;
if _e1455 {
phi_2229_ = (~(_e1452) + select(0u, 1u, (_e1444 == 0u)));
} else {
phi_2229_ = _e1452;
}
let _e1465 = phi_2229_;
let _e1487 = ((((f32(bitcast<i32>(((_e1465 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1465 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1461 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1461 & 65535u)))));
let _e1494 = select(_e1436, _e354, (_e354 < _e1436));
let _e1500 = global_5.member[bitcast<u32>(select(0i, _e1494, (_e1494 > 0i)))];
let _e1502 = select(_e1436, _e363, (_e363 < _e1436));
let _e1508 = global_5.member[bitcast<u32>(select(0i, _e1502, (_e1502 > 0i)))];
let _e1511 = ((_e1508 >> bitcast<u32>(31i)) != 0u);
if _e1511 {
phi_2291_ = (~(_e1500) + 1u);
} else {
phi_2291_ = _e1500;
}
let _e1517 = phi_2291_;
if _e1511 {
phi_2297_ = (~(_e1508) + select(0u, 1u, (_e1500 == 0u)));
} else {
phi_2297_ = _e1508;
}
let _e1521 = phi_2297_;
let _e1543 = ((((f32(bitcast<i32>(((_e1521 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1521 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1517 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1517 & 65535u)))));
let _e1550 = select(_e1436, _e412, (_e412 < _e1436));
let _e1556 = global_5.member[bitcast<u32>(select(0i, _e1550, (_e1550 > 0i)))];
let _e1558 = select(_e1436, _e421, (_e421 < _e1436));
let _e1564 = global_5.member[bitcast<u32>(select(0i, _e1558, (_e1558 > 0i)))];
let _e1567 = ((_e1564 >> bitcast<u32>(31i)) != 0u);
if _e1567 {
phi_2359_ = (~(_e1556) + 1u);
} else {
phi_2359_ = _e1556;
}
let _e1573 = phi_2359_;
if _e1567 {
phi_2365_ = (~(_e1564) + select(0u, 1u, (_e1556 == 0u)));
} else {
phi_2365_ = _e1564;
}
let _e1577 = phi_2365_;
let _e1599 = ((((f32(bitcast<i32>(((_e1577 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1577 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1573 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1573 & 65535u)))));
phi_2388_ = vec3<f32>(select(_e1487, -(bitcast<f32>((bitcast<u32>(_e1487) & 2147483647u))), _e1455), select(_e1543, -(bitcast<f32>((bitcast<u32>(_e1543) & 2147483647u))), _e1511), select(_e1599, -(bitcast<f32>((bitcast<u32>(_e1599) & 2147483647u))), _e1567));
phi_2391_ = 1u;
loop {
let _e1607 = phi_2388_;
let _e1609 = phi_2391_;
local_12 = _e1607;
local_13 = _e1607;
local_14 = _e1607;
let _e1611 = local_7;
let _e1612 = (_e1609 <= _e1611);
if _e1612 {
let _e1613 = (_e1609 & 31u);
let _e1617 = (1f / f32((1i << bitcast<u32>(_e1613))));
let _e1621 = (((f32(_e270) + 0.5f) * _e1617) - 0.5f);
let _e1625 = (((f32(_e271) + 0.5f) * _e1617) - 0.5f);
let _e1627 = select(-1f, _e1621, (_e1621 > -1f));
let _e1629 = select(1e6f, _e1627, (_e1627 < 1e6f));
let _e1636 = select(0i, select(select(i32(_e1629), i32(-2147483648), (_e1629 < -2147483600f)), 2147483647i, (_e1629 > 2147483500f)), (_e1629 == _e1629));
let _e1640 = (_e1636 - select(0i, 1i, (_e1629 < f32(_e1636))));
let _e1642 = select(-1f, _e1625, (_e1625 > -1f));
let _e1644 = select(1e6f, _e1642, (_e1642 < 1e6f));
let _e1651 = select(0i, select(select(i32(_e1644), i32(-2147483648), (_e1644 < -2147483600f)), 2147483647i, (_e1644 > 2147483500f)), (_e1644 == _e1644));
let _e1655 = (_e1651 - select(0i, 1i, (_e1644 < f32(_e1651))));
let _e1657 = (_e1621 - f32(_e1640));
let _e1659 = (_e1625 - f32(_e1655));
let _e1661 = (1u << bitcast<u32>(_e1613));
let _e1670 = bitcast<i32>((((_e275 + _e1661) - 1u) >> bitcast<u32>(_e1613)));
let _e1671 = (_e1670 - 1i);
let _e1673 = (bitcast<i32>((((_e279 + _e1661) - 1u) >> bitcast<u32>(_e1613))) - 1i);
let _e1675 = select(_e1671, _e1640, (_e1640 < _e1671));
let _e1677 = select(_e1673, _e1655, (_e1655 < _e1673));
let _e1679 = select(0i, _e1675, (_e1675 > 0i));
phi_2511_ = 0u;
phi_2514_ = 0u;
loop {
let _e1683 = phi_2511_;
let _e1685 = phi_2514_;
local_8 = _e1685;
let _e1686 = (_e1683 < _e1609);
if _e1686 {
let _e1687 = (_e1683 & 31u);
let _e1689 = (1u << bitcast<u32>(_e1687));
phi_2512_ = (_e1683 + 1u);
phi_2515_ = (_e1685 + ((((_e275 + _e1689) - 1u) >> bitcast<u32>(_e1687)) * (((_e279 + _e1689) - 1u) >> bitcast<u32>(_e1687))));
} else {
phi_2512_ = u32();
phi_2515_ = u32();
}
let _e1702 = phi_2512_;
let _e1704 = phi_2515_;
continue;
continuing {
phi_2511_ = _e1702;
phi_2514_ = _e1704;
break if !(_e1686);
}
}
let _e1707 = local_8;
let _e1709 = (select(0i, _e1677, (_e1677 > 0i)) * _e1670);
let _e1712 = (((bitcast<i32>(_e1707) + _e1709) + _e1679) * 6i);
let _e1714 = select(_e1436, _e1712, (_e1712 < _e1436));
let _e1720 = global_5.member[bitcast<u32>(select(0i, _e1714, (_e1714 > 0i)))];
let _e1721 = (_e1712 + 1i);
let _e1723 = select(_e1436, _e1721, (_e1721 < _e1436));
let _e1729 = global_5.member[bitcast<u32>(select(0i, _e1723, (_e1723 > 0i)))];
let _e1732 = ((_e1729 >> bitcast<u32>(31i)) != 0u);
if _e1732 {
phi_2595_ = (~(_e1720) + 1u);
} else {
phi_2595_ = _e1720;
}
let _e1738 = phi_2595_;
if _e1732 {
phi_2601_ = (~(_e1729) + select(0u, 1u, (_e1720 == 0u)));
} else {
phi_2601_ = _e1729;
}
let _e1742 = phi_2601_;
let _e1764 = ((((f32(bitcast<i32>(((_e1742 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1742 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1738 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1738 & 65535u)))));
let _e1770 = (_e1712 + 2i);
let _e1772 = select(_e1436, _e1770, (_e1770 < _e1436));
let _e1778 = global_5.member[bitcast<u32>(select(0i, _e1772, (_e1772 > 0i)))];
let _e1779 = (_e1712 + 3i);
let _e1781 = select(_e1436, _e1779, (_e1779 < _e1436));
let _e1787 = global_5.member[bitcast<u32>(select(0i, _e1781, (_e1781 > 0i)))];
let _e1790 = ((_e1787 >> bitcast<u32>(31i)) != 0u);
if _e1790 {
phi_2663_ = (~(_e1778) + 1u);
} else {
phi_2663_ = _e1778;
}
let _e1796 = phi_2663_;
if _e1790 {
phi_2669_ = (~(_e1787) + select(0u, 1u, (_e1778 == 0u)));
} else {
phi_2669_ = _e1787;
}
let _e1800 = phi_2669_;
let _e1822 = ((((f32(bitcast<i32>(((_e1800 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1800 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1796 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1796 & 65535u)))));
let _e1828 = (_e1712 + 4i);
let _e1830 = select(_e1436, _e1828, (_e1828 < _e1436));
let _e1836 = global_5.member[bitcast<u32>(select(0i, _e1830, (_e1830 > 0i)))];
let _e1837 = (_e1712 + 5i);
let _e1839 = select(_e1436, _e1837, (_e1837 < _e1436));
let _e1845 = global_5.member[bitcast<u32>(select(0i, _e1839, (_e1839 > 0i)))];
let _e1848 = ((_e1845 >> bitcast<u32>(31i)) != 0u);
if _e1848 {
phi_2731_ = (~(_e1836) + 1u);
} else {
phi_2731_ = _e1836;
}
let _e1854 = phi_2731_;
if _e1848 {
phi_2737_ = (~(_e1845) + select(0u, 1u, (_e1836 == 0u)));
} else {
phi_2737_ = _e1845;
}
let _e1858 = phi_2737_;
let _e1880 = ((((f32(bitcast<i32>(((_e1858 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1858 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1854 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1854 & 65535u)))));
let _e1886 = (1f - _e1657);
let _e1890 = (_e1640 + 1i);
let _e1892 = select(_e1671, _e1890, (_e1890 < _e1671));
let _e1894 = select(0i, _e1892, (_e1892 > 0i));
phi_2810_ = 0u;
phi_2813_ = 0u;
loop {
let _e1896 = phi_2810_;
let _e1898 = phi_2813_;
local_9 = _e1898;
let _e1899 = (_e1896 < _e1609);
if _e1899 {
let _e1900 = (_e1896 & 31u);
let _e1902 = (1u << bitcast<u32>(_e1900));
phi_2811_ = (_e1896 + 1u);
phi_2814_ = (_e1898 + ((((_e275 + _e1902) - 1u) >> bitcast<u32>(_e1900)) * (((_e279 + _e1902) - 1u) >> bitcast<u32>(_e1900))));
} else {
phi_2811_ = u32();
phi_2814_ = u32();
}
let _e1915 = phi_2811_;
let _e1917 = phi_2814_;
continue;
continuing {
phi_2810_ = _e1915;
phi_2813_ = _e1917;
break if !(_e1899);
}
}
let _e1920 = local_9;
let _e1924 = (((bitcast<i32>(_e1920) + _e1709) + _e1894) * 6i);
let _e1926 = select(_e1436, _e1924, (_e1924 < _e1436));
let _e1932 = global_5.member[bitcast<u32>(select(0i, _e1926, (_e1926 > 0i)))];
let _e1933 = (_e1924 + 1i);
let _e1935 = select(_e1436, _e1933, (_e1933 < _e1436));
let _e1941 = global_5.member[bitcast<u32>(select(0i, _e1935, (_e1935 > 0i)))];
let _e1944 = ((_e1941 >> bitcast<u32>(31i)) != 0u);
if _e1944 {
phi_2894_ = (~(_e1932) + 1u);
} else {
phi_2894_ = _e1932;
}
let _e1950 = phi_2894_;
if _e1944 {
phi_2900_ = (~(_e1941) + select(0u, 1u, (_e1932 == 0u)));
} else {
phi_2900_ = _e1941;
}
let _e1954 = phi_2900_;
let _e1976 = ((((f32(bitcast<i32>(((_e1954 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1954 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1950 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1950 & 65535u)))));
let _e1982 = (_e1924 + 2i);
let _e1984 = select(_e1436, _e1982, (_e1982 < _e1436));
let _e1990 = global_5.member[bitcast<u32>(select(0i, _e1984, (_e1984 > 0i)))];
let _e1991 = (_e1924 + 3i);
let _e1993 = select(_e1436, _e1991, (_e1991 < _e1436));
let _e1999 = global_5.member[bitcast<u32>(select(0i, _e1993, (_e1993 > 0i)))];
let _e2002 = ((_e1999 >> bitcast<u32>(31i)) != 0u);
if _e2002 {
phi_2962_ = (~(_e1990) + 1u);
} else {
phi_2962_ = _e1990;
}
let _e2008 = phi_2962_;
if _e2002 {
phi_2968_ = (~(_e1999) + select(0u, 1u, (_e1990 == 0u)));
} else {
phi_2968_ = _e1999;
}
let _e2012 = phi_2968_;
let _e2034 = ((((f32(bitcast<i32>(((_e2012 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2012 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2008 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2008 & 65535u)))));
let _e2040 = (_e1924 + 4i);
let _e2042 = select(_e1436, _e2040, (_e2040 < _e1436));
let _e2048 = global_5.member[bitcast<u32>(select(0i, _e2042, (_e2042 > 0i)))];
let _e2049 = (_e1924 + 5i);
let _e2051 = select(_e1436, _e2049, (_e2049 < _e1436));
let _e2057 = global_5.member[bitcast<u32>(select(0i, _e2051, (_e2051 > 0i)))];
let _e2060 = ((_e2057 >> bitcast<u32>(31i)) != 0u);
if _e2060 {
phi_3030_ = (~(_e2048) + 1u);
} else {
phi_3030_ = _e2048;
}
let _e2066 = phi_3030_;
if _e2060 {
phi_3036_ = (~(_e2057) + select(0u, 1u, (_e2048 == 0u)));
} else {
phi_3036_ = _e2057;
}
let _e2070 = phi_3036_;
let _e2092 = ((((f32(bitcast<i32>(((_e2070 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2070 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2066 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2066 & 65535u)))));
let _e2104 = (_e1655 + 1i);
let _e2106 = select(_e1673, _e2104, (_e2104 < _e1673));
phi_3111_ = 0u;
phi_3114_ = 0u;
loop {
let _e2110 = phi_3111_;
let _e2112 = phi_3114_;
local_10 = _e2112;
let _e2113 = (_e2110 < _e1609);
if _e2113 {
let _e2114 = (_e2110 & 31u);
let _e2116 = (1u << bitcast<u32>(_e2114));
phi_3112_ = (_e2110 + 1u);
phi_3115_ = (_e2112 + ((((_e275 + _e2116) - 1u) >> bitcast<u32>(_e2114)) * (((_e279 + _e2116) - 1u) >> bitcast<u32>(_e2114))));
} else {
phi_3112_ = u32();
phi_3115_ = u32();
}
let _e2129 = phi_3112_;
let _e2131 = phi_3115_;
continue;
continuing {
phi_3111_ = _e2129;
phi_3114_ = _e2131;
break if !(_e2113);
}
}
let _e2134 = local_10;
let _e2136 = (select(0i, _e2106, (_e2106 > 0i)) * _e1670);
let _e2139 = (((bitcast<i32>(_e2134) + _e2136) + _e1679) * 6i);
let _e2141 = select(_e1436, _e2139, (_e2139 < _e1436));
let _e2147 = global_5.member[bitcast<u32>(select(0i, _e2141, (_e2141 > 0i)))];
let _e2148 = (_e2139 + 1i);
let _e2150 = select(_e1436, _e2148, (_e2148 < _e1436));
let _e2156 = global_5.member[bitcast<u32>(select(0i, _e2150, (_e2150 > 0i)))];
let _e2159 = ((_e2156 >> bitcast<u32>(31i)) != 0u);
if _e2159 {
phi_3195_ = (~(_e2147) + 1u);
} else {
phi_3195_ = _e2147;
}
let _e2165 = phi_3195_;
if _e2159 {
phi_3201_ = (~(_e2156) + select(0u, 1u, (_e2147 == 0u)));
} else {
phi_3201_ = _e2156;
}
let _e2169 = phi_3201_;
let _e2191 = ((((f32(bitcast<i32>(((_e2169 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2169 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2165 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2165 & 65535u)))));
let _e2197 = (_e2139 + 2i);
let _e2199 = select(_e1436, _e2197, (_e2197 < _e1436));
let _e2205 = global_5.member[bitcast<u32>(select(0i, _e2199, (_e2199 > 0i)))];
let _e2206 = (_e2139 + 3i);
let _e2208 = select(_e1436, _e2206, (_e2206 < _e1436));
let _e2214 = global_5.member[bitcast<u32>(select(0i, _e2208, (_e2208 > 0i)))];
let _e2217 = ((_e2214 >> bitcast<u32>(31i)) != 0u);
if _e2217 {
phi_3263_ = (~(_e2205) + 1u);
} else {
phi_3263_ = _e2205;
}
let _e2223 = phi_3263_;
if _e2217 {
phi_3269_ = (~(_e2214) + select(0u, 1u, (_e2205 == 0u)));
} else {
phi_3269_ = _e2214;
}
let _e2227 = phi_3269_;
let _e2249 = ((((f32(bitcast<i32>(((_e2227 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2227 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2223 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2223 & 65535u)))));
let _e2255 = (_e2139 + 4i);
let _e2257 = select(_e1436, _e2255, (_e2255 < _e1436));
let _e2263 = global_5.member[bitcast<u32>(select(0i, _e2257, (_e2257 > 0i)))];
let _e2264 = (_e2139 + 5i);
let _e2266 = select(_e1436, _e2264, (_e2264 < _e1436));
let _e2272 = global_5.member[bitcast<u32>(select(0i, _e2266, (_e2266 > 0i)))];
let _e2275 = ((_e2272 >> bitcast<u32>(31i)) != 0u);
if _e2275 {
phi_3331_ = (~(_e2263) + 1u);
} else {
phi_3331_ = _e2263;
}
let _e2281 = phi_3331_;
if _e2275 {
phi_3337_ = (~(_e2272) + select(0u, 1u, (_e2263 == 0u)));
} else {
phi_3337_ = _e2272;
}
let _e2285 = phi_3337_;
let _e2307 = ((((f32(bitcast<i32>(((_e2285 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2285 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2281 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2281 & 65535u)))));
phi_3411_ = 0u;
phi_3414_ = 0u;
loop {
let _e2317 = phi_3411_;
let _e2319 = phi_3414_;
local_11 = _e2319;
let _e2320 = (_e2317 < _e1609);
if _e2320 {
let _e2321 = (_e2317 & 31u);
let _e2323 = (1u << bitcast<u32>(_e2321));
phi_3412_ = (_e2317 + 1u);
phi_3415_ = (_e2319 + ((((_e275 + _e2323) - 1u) >> bitcast<u32>(_e2321)) * (((_e279 + _e2323) - 1u) >> bitcast<u32>(_e2321))));
} else {
phi_3412_ = u32();
phi_3415_ = u32();
}
let _e2336 = phi_3412_;
let _e2338 = phi_3415_;
continue;
continuing {
phi_3411_ = _e2336;
phi_3414_ = _e2338;
break if !(_e2320);
}
}
let _e2341 = local_11;
let _e2345 = (((bitcast<i32>(_e2341) + _e2136) + _e1894) * 6i);
let _e2347 = select(_e1436, _e2345, (_e2345 < _e1436));
let _e2353 = global_5.member[bitcast<u32>(select(0i, _e2347, (_e2347 > 0i)))];
let _e2354 = (_e2345 + 1i);
let _e2356 = select(_e1436, _e2354, (_e2354 < _e1436));
let _e2362 = global_5.member[bitcast<u32>(select(0i, _e2356, (_e2356 > 0i)))];
let _e2365 = ((_e2362 >> bitcast<u32>(31i)) != 0u);
if _e2365 {
phi_3495_ = (~(_e2353) + 1u);
} else {
phi_3495_ = _e2353;
}
let _e2371 = phi_3495_;
if _e2365 {
phi_3501_ = (~(_e2362) + select(0u, 1u, (_e2353 == 0u)));
} else {
phi_3501_ = _e2362;
}
let _e2375 = phi_3501_;
let _e2397 = ((((f32(bitcast<i32>(((_e2375 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2375 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2371 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2371 & 65535u)))));
let _e2403 = (_e2345 + 2i);
let _e2405 = select(_e1436, _e2403, (_e2403 < _e1436));
let _e2411 = global_5.member[bitcast<u32>(select(0i, _e2405, (_e2405 > 0i)))];
let _e2412 = (_e2345 + 3i);
let _e2414 = select(_e1436, _e2412, (_e2412 < _e1436));
let _e2420 = global_5.member[bitcast<u32>(select(0i, _e2414, (_e2414 > 0i)))];
let _e2423 = ((_e2420 >> bitcast<u32>(31i)) != 0u);
if _e2423 {
phi_3563_ = (~(_e2411) + 1u);
} else {
phi_3563_ = _e2411;
}
let _e2429 = phi_3563_;
if _e2423 {
phi_3569_ = (~(_e2420) + select(0u, 1u, (_e2411 == 0u)));
} else {
phi_3569_ = _e2420;
}
let _e2433 = phi_3569_;
let _e2455 = ((((f32(bitcast<i32>(((_e2433 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2433 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2429 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2429 & 65535u)))));
let _e2461 = (_e2345 + 4i);
let _e2463 = select(_e1436, _e2461, (_e2461 < _e1436));
let _e2469 = global_5.member[bitcast<u32>(select(0i, _e2463, (_e2463 > 0i)))];
let _e2470 = (_e2345 + 5i);
let _e2472 = select(_e1436, _e2470, (_e2470 < _e1436));
let _e2478 = global_5.member[bitcast<u32>(select(0i, _e2472, (_e2472 > 0i)))];
let _e2481 = ((_e2478 >> bitcast<u32>(31i)) != 0u);
if _e2481 {
phi_3631_ = (~(_e2469) + 1u);
} else {
phi_3631_ = _e2469;
}
let _e2487 = phi_3631_;
if _e2481 {
phi_3637_ = (~(_e2478) + select(0u, 1u, (_e2469 == 0u)));
} else {
phi_3637_ = _e2478;
}
let _e2491 = phi_3637_;
let _e2513 = ((((f32(bitcast<i32>(((_e2491 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2491 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2487 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2487 & 65535u)))));
let _e2525 = (1f - _e1659);
phi_2389_ = vec3<f32>((_e1607.x + ((((select(_e1764, -(bitcast<f32>((bitcast<u32>(_e1764) & 2147483647u))), _e1732) * _e1886) + (select(_e1976, -(bitcast<f32>((bitcast<u32>(_e1976) & 2147483647u))), _e1944) * _e1657)) * _e2525) + (((select(_e2191, -(bitcast<f32>((bitcast<u32>(_e2191) & 2147483647u))), _e2159) * _e1886) + (select(_e2397, -(bitcast<f32>((bitcast<u32>(_e2397) & 2147483647u))), _e2365) * _e1657)) * _e1659))), (_e1607.y + ((((select(_e1822, -(bitcast<f32>((bitcast<u32>(_e1822) & 2147483647u))), _e1790) * _e1886) + (select(_e2034, -(bitcast<f32>((bitcast<u32>(_e2034) & 2147483647u))), _e2002) * _e1657)) * _e2525) + (((select(_e2249, -(bitcast<f32>((bitcast<u32>(_e2249) & 2147483647u))), _e2217) * _e1886) + (select(_e2455, -(bitcast<f32>((bitcast<u32>(_e2455) & 2147483647u))), _e2423) * _e1657)) * _e1659))), (_e1607.z + ((((select(_e1880, -(bitcast<f32>((bitcast<u32>(_e1880) & 2147483647u))), _e1848) * _e1886) + (select(_e2092, -(bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u))), _e2060) * _e1657)) * _e2525) + (((select(_e2307, -(bitcast<f32>((bitcast<u32>(_e2307) & 2147483647u))), _e2275) * _e1886) + (select(_e2513, -(bitcast<f32>((bitcast<u32>(_e2513) & 2147483647u))), _e2481) * _e1657)) * _e1659))));
phi_2392_ = (_e1609 + 1u);
} else {
phi_2389_ = vec3<f32>();
phi_2392_ = u32();
}
let _e2544 = phi_2389_;
let _e2546 = phi_2392_;
continue;
continuing {
phi_2388_ = _e2544;
phi_2391_ = _e2546;
break if !(_e1612);
}
}
let _e2549 = local_12;
let _e2553 = local_13;
let _e2557 = local_14;
let _e2560 = ((_e2549.x * _e1419) + _e203);
let _e2561 = ((_e2553.y * _e1419) + _e214);
let _e2562 = ((_e2557.z * _e1419) + _e225);
let _e2563 = (_e137 - _e2560);
let _e2564 = (_e148 - _e2561);
let _e2565 = (_e159 - _e2562);
let _e2583 = global_2.member.member_2.member;
let _e2584 = (((((f32(_e270) + 0.5f) / f32(_e280)) * 2f) - 1f) * _e2583);
let _e2592 = global_2.member.member_2.member_1;
let _e2593 = ((1f - (((f32(_e271) + 0.5f) / f32(_e282)) * 2f)) * _e2592);
let _e2596 = global_2.member.member_3;
let _e2605 = global_2.member.member_4;
let _e2618 = global_2.member.member_2.member_3;
let _e2619 = (_e2618 != 0u);
let _e2622 = global_2.member.member_5;
let _e2629 = select((_e2622.member + ((_e2596.member * _e2584) + (_e2605.member * _e2593))), _e2622.member, _e2619);
let _e2630 = select((_e2622.member_1 + ((_e2596.member_1 * _e2584) + (_e2605.member_1 * _e2593))), _e2622.member_1, _e2619);
let _e2631 = select((_e2622.member_2 + ((_e2596.member_2 * _e2584) + (_e2605.member_2 * _e2593))), _e2622.member_2, _e2619);
let _e2641 = (((_e2629 * _e2629) + (_e2630 * _e2630)) + (_e2631 * _e2631));
let _e2669 = select(0f, _e236, (_e236 > 0f));
let _e2677 = global_2.member.member_7;
global_1.member[_e71] = ((_e104 + select(0f, _e2563, (_e2563 > 0f))) + _e1432);
global_1.member[(_e69 + _e71)] = ((_e115 + select(0f, _e2564, (_e2564 > 0f))) + _e1433);
global_1.member[((2u * _e69) + _e71)] = ((_e126 + select(0f, _e2565, (_e2565 > 0f))) + _e1434);
global_1.member[((3u * _e69) + _e71)] = select(1f, _e2669, (_e2669 < 1f));
global_1.member[((4u * _e69) + _e71)] = _e104;
global_1.member[((5u * _e69) + _e71)] = _e115;
global_1.member[((6u * _e69) + _e71)] = _e126;
global_1.member[((7u * _e69) + _e71)] = _e137;
global_1.member[((8u * _e69) + _e71)] = _e148;
global_1.member[((9u * _e69) + _e71)] = _e159;
global_1.member[((10u * _e69) + _e71)] = _e1432;
global_1.member[((11u * _e69) + _e71)] = _e1433;
global_1.member[((12u * _e69) + _e71)] = _e1434;
global_1.member[((13u * _e69) + _e71)] = _e2560;
global_1.member[((14u * _e69) + _e71)] = _e2561;
global_1.member[((15u * _e69) + _e71)] = _e2562;
global_1.member[((16u * _e69) + _e71)] = select(0f, ((_e93 * ((((_e2622.member * _e2629) + (_e2622.member_1 * _e2630)) + (_e2622.member_2 * _e2631)) / sqrt(select(0f, _e2641, (_e2641 > 0f))))) * _e2677), (_e93 < (0.5f * 1e30f)));
global_1.member[((17u * _e69) + _e71)] = (((_e2596.member * _e247) + (_e2596.member_1 * _e258)) + (_e2596.member_2 * _e269));
global_1.member[((18u * _e69) + _e71)] = (((_e2605.member * _e247) + (_e2605.member_1 * _e258)) + (_e2605.member_2 * _e269));
global_1.member[((19u * _e69) + _e71)] = -((((_e2622.member * _e247) + (_e2622.member_1 * _e258)) + (_e2622.member_2 * _e269)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
