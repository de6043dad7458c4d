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
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
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
var phi_927_: u32;
var phi_928_: u32;
var phi_929_: u32;
var phi_988_: u32;
var phi_994_: u32;
var phi_1056_: u32;
var phi_1062_: u32;
var phi_1124_: u32;
var phi_1130_: u32;
var phi_1226_: u32;
var phi_1227_: u32;
var phi_1228_: u32;
var phi_1287_: u32;
var phi_1293_: u32;
var phi_1355_: u32;
var phi_1361_: u32;
var phi_1423_: u32;
var phi_1429_: u32;
var phi_1527_: u32;
var phi_1528_: u32;
var phi_1529_: u32;
var phi_1588_: u32;
var phi_1594_: u32;
var phi_1656_: u32;
var phi_1662_: u32;
var phi_1724_: u32;
var phi_1730_: u32;
var phi_1827_: u32;
var phi_1828_: u32;
var phi_1829_: u32;
var phi_1888_: u32;
var phi_1894_: u32;
var phi_1956_: u32;
var phi_1962_: u32;
var phi_2024_: u32;
var phi_2030_: u32;
var phi_782_: vec3<f32>;
var phi_785_: u32;
var local: vec3<f32>;
var local_1: vec3<f32>;
var local_2: vec3<f32>;
var phi_2223_: u32;
var phi_2229_: u32;
var phi_2291_: u32;
var phi_2297_: u32;
var phi_2359_: u32;
var phi_2365_: u32;
var phi_2388_: vec3<f32>;
var phi_2391_: u32;
var local_3: u32;
var phi_2534_: u32;
var phi_2535_: u32;
var phi_2536_: u32;
var phi_2595_: u32;
var phi_2601_: u32;
var phi_2663_: u32;
var phi_2669_: u32;
var phi_2731_: u32;
var phi_2737_: u32;
var phi_2833_: u32;
var phi_2834_: u32;
var phi_2835_: u32;
var phi_2894_: u32;
var phi_2900_: u32;
var phi_2962_: u32;
var phi_2968_: u32;
var phi_3030_: u32;
var phi_3036_: u32;
var phi_3134_: u32;
var phi_3135_: u32;
var phi_3136_: u32;
var phi_3195_: u32;
var phi_3201_: u32;
var phi_3263_: u32;
var phi_3269_: u32;
var phi_3331_: u32;
var phi_3337_: u32;
var phi_3434_: u32;
var phi_3435_: u32;
var phi_3436_: u32;
var phi_3495_: u32;
var phi_3501_: u32;
var phi_3563_: u32;
var phi_3569_: u32;
var phi_3631_: u32;
var phi_3637_: u32;
var phi_2389_: vec3<f32>;
var phi_2392_: u32;
var local_4: vec3<f32>;
var local_5: vec3<f32>;
var local_6: vec3<f32>;
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
local = _e472;
local_1 = _e472;
local_2 = _e472;
let _e478 = global_2.member.member_18.member_1;
let _e479 = (_e474 <= _e478);
local_3 = _e478;
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
let _e552 = global_2.member.member_18.member_2;
let _e556 = global_2.member.member_18.member_3;
let _e560 = global_2.member.member_18.member_4;
let _e564 = global_2.member.member_18.member_5;
let _e565 = (_e474 == 0u);
if _e565 {
phi_929_ = 0u;
} else {
if (_e474 == 1u) {
phi_928_ = _e552;
} else {
if (_e474 == 2u) {
phi_927_ = _e556;
} else {
phi_927_ = select(_e564, _e560, (_e474 == 3u));
}
let _e571 = phi_927_;
phi_928_ = _e571;
}
let _e573 = phi_928_;
phi_929_ = _e573;
}
let _e575 = phi_929_;
let _e577 = (select(0i, _e544, (_e544 > 0i)) * _e537);
let _e580 = (((bitcast<i32>(_e575) + _e577) + _e546) * 6i);
let _e582 = select(_e296, _e580, (_e580 < _e296));
let _e588 = global_4.member[bitcast<u32>(select(0i, _e582, (_e582 > 0i)))];
let _e589 = (_e580 + 1i);
let _e591 = select(_e296, _e589, (_e589 < _e296));
let _e597 = global_4.member[bitcast<u32>(select(0i, _e591, (_e591 > 0i)))];
let _e600 = ((_e597 >> bitcast<u32>(31i)) != 0u);
if _e600 {
phi_988_ = (~(_e588) + 1u);
} else {
phi_988_ = _e588;
}
let _e606 = phi_988_;
if _e600 {
phi_994_ = (~(_e597) + select(0u, 1u, (_e588 == 0u)));
} else {
phi_994_ = _e597;
}
let _e610 = phi_994_;
let _e632 = ((((f32(bitcast<i32>(((_e610 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e610 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e606 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e606 & 65535u)))));
let _e638 = (_e580 + 2i);
let _e640 = select(_e296, _e638, (_e638 < _e296));
let _e646 = global_4.member[bitcast<u32>(select(0i, _e640, (_e640 > 0i)))];
let _e647 = (_e580 + 3i);
let _e649 = select(_e296, _e647, (_e647 < _e296));
let _e655 = global_4.member[bitcast<u32>(select(0i, _e649, (_e649 > 0i)))];
let _e658 = ((_e655 >> bitcast<u32>(31i)) != 0u);
if _e658 {
phi_1056_ = (~(_e646) + 1u);
} else {
phi_1056_ = _e646;
}
let _e664 = phi_1056_;
if _e658 {
phi_1062_ = (~(_e655) + select(0u, 1u, (_e646 == 0u)));
} else {
phi_1062_ = _e655;
}
let _e668 = phi_1062_;
let _e690 = ((((f32(bitcast<i32>(((_e668 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e668 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e664 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e664 & 65535u)))));
let _e696 = (_e580 + 4i);
let _e698 = select(_e296, _e696, (_e696 < _e296));
let _e704 = global_4.member[bitcast<u32>(select(0i, _e698, (_e698 > 0i)))];
let _e705 = (_e580 + 5i);
let _e707 = select(_e296, _e705, (_e705 < _e296));
let _e713 = global_4.member[bitcast<u32>(select(0i, _e707, (_e707 > 0i)))];
let _e716 = ((_e713 >> bitcast<u32>(31i)) != 0u);
if _e716 {
phi_1124_ = (~(_e704) + 1u);
} else {
phi_1124_ = _e704;
}
let _e722 = phi_1124_;
if _e716 {
phi_1130_ = (~(_e713) + select(0u, 1u, (_e704 == 0u)));
} else {
phi_1130_ = _e713;
}
let _e726 = phi_1130_;
let _e748 = ((((f32(bitcast<i32>(((_e726 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e726 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e722 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e722 & 65535u)))));
let _e754 = (1f - _e524);
let _e758 = (_e507 + 1i);
let _e760 = select(_e538, _e758, (_e758 < _e538));
let _e762 = select(0i, _e760, (_e760 > 0i));
if _e565 {
phi_1228_ = 0u;
} else {
if (_e474 == 1u) {
phi_1227_ = _e552;
} else {
if (_e474 == 2u) {
phi_1226_ = _e556;
} else {
phi_1226_ = select(_e564, _e560, (_e474 == 3u));
}
let _e768 = phi_1226_;
phi_1227_ = _e768;
}
let _e770 = phi_1227_;
phi_1228_ = _e770;
}
let _e772 = phi_1228_;
let _e776 = (((bitcast<i32>(_e772) + _e577) + _e762) * 6i);
let _e778 = select(_e296, _e776, (_e776 < _e296));
let _e784 = global_4.member[bitcast<u32>(select(0i, _e778, (_e778 > 0i)))];
let _e785 = (_e776 + 1i);
let _e787 = select(_e296, _e785, (_e785 < _e296));
let _e793 = global_4.member[bitcast<u32>(select(0i, _e787, (_e787 > 0i)))];
let _e796 = ((_e793 >> bitcast<u32>(31i)) != 0u);
if _e796 {
phi_1287_ = (~(_e784) + 1u);
} else {
phi_1287_ = _e784;
}
let _e802 = phi_1287_;
if _e796 {
phi_1293_ = (~(_e793) + select(0u, 1u, (_e784 == 0u)));
} else {
phi_1293_ = _e793;
}
let _e806 = phi_1293_;
let _e828 = ((((f32(bitcast<i32>(((_e806 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e806 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e802 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e802 & 65535u)))));
let _e834 = (_e776 + 2i);
let _e836 = select(_e296, _e834, (_e834 < _e296));
let _e842 = global_4.member[bitcast<u32>(select(0i, _e836, (_e836 > 0i)))];
let _e843 = (_e776 + 3i);
let _e845 = select(_e296, _e843, (_e843 < _e296));
let _e851 = global_4.member[bitcast<u32>(select(0i, _e845, (_e845 > 0i)))];
let _e854 = ((_e851 >> bitcast<u32>(31i)) != 0u);
if _e854 {
phi_1355_ = (~(_e842) + 1u);
} else {
phi_1355_ = _e842;
}
let _e860 = phi_1355_;
if _e854 {
phi_1361_ = (~(_e851) + select(0u, 1u, (_e842 == 0u)));
} else {
phi_1361_ = _e851;
}
let _e864 = phi_1361_;
let _e886 = ((((f32(bitcast<i32>(((_e864 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e864 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e860 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e860 & 65535u)))));
let _e892 = (_e776 + 4i);
let _e894 = select(_e296, _e892, (_e892 < _e296));
let _e900 = global_4.member[bitcast<u32>(select(0i, _e894, (_e894 > 0i)))];
let _e901 = (_e776 + 5i);
let _e903 = select(_e296, _e901, (_e901 < _e296));
let _e909 = global_4.member[bitcast<u32>(select(0i, _e903, (_e903 > 0i)))];
let _e912 = ((_e909 >> bitcast<u32>(31i)) != 0u);
if _e912 {
phi_1423_ = (~(_e900) + 1u);
} else {
phi_1423_ = _e900;
}
let _e918 = phi_1423_;
if _e912 {
phi_1429_ = (~(_e909) + select(0u, 1u, (_e900 == 0u)));
} else {
phi_1429_ = _e909;
}
let _e922 = phi_1429_;
let _e944 = ((((f32(bitcast<i32>(((_e922 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e922 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e918 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e918 & 65535u)))));
let _e956 = (_e522 + 1i);
let _e958 = select(_e540, _e956, (_e956 < _e540));
if _e565 {
phi_1529_ = 0u;
} else {
if (_e474 == 1u) {
phi_1528_ = _e552;
} else {
if (_e474 == 2u) {
phi_1527_ = _e556;
} else {
phi_1527_ = select(_e564, _e560, (_e474 == 3u));
}
let _e966 = phi_1527_;
phi_1528_ = _e966;
}
let _e968 = phi_1528_;
phi_1529_ = _e968;
}
let _e970 = phi_1529_;
let _e972 = (select(0i, _e958, (_e958 > 0i)) * _e537);
let _e975 = (((bitcast<i32>(_e970) + _e972) + _e546) * 6i);
let _e977 = select(_e296, _e975, (_e975 < _e296));
let _e983 = global_4.member[bitcast<u32>(select(0i, _e977, (_e977 > 0i)))];
let _e984 = (_e975 + 1i);
let _e986 = select(_e296, _e984, (_e984 < _e296));
let _e992 = global_4.member[bitcast<u32>(select(0i, _e986, (_e986 > 0i)))];
let _e995 = ((_e992 >> bitcast<u32>(31i)) != 0u);
if _e995 {
phi_1588_ = (~(_e983) + 1u);
} else {
phi_1588_ = _e983;
}
let _e1001 = phi_1588_;
if _e995 {
phi_1594_ = (~(_e992) + select(0u, 1u, (_e983 == 0u)));
} else {
phi_1594_ = _e992;
}
let _e1005 = phi_1594_;
let _e1027 = ((((f32(bitcast<i32>(((_e1005 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1005 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1001 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1001 & 65535u)))));
let _e1033 = (_e975 + 2i);
let _e1035 = select(_e296, _e1033, (_e1033 < _e296));
let _e1041 = global_4.member[bitcast<u32>(select(0i, _e1035, (_e1035 > 0i)))];
let _e1042 = (_e975 + 3i);
let _e1044 = select(_e296, _e1042, (_e1042 < _e296));
let _e1050 = global_4.member[bitcast<u32>(select(0i, _e1044, (_e1044 > 0i)))];
let _e1053 = ((_e1050 >> bitcast<u32>(31i)) != 0u);
if _e1053 {
phi_1656_ = (~(_e1041) + 1u);
} else {
phi_1656_ = _e1041;
}
let _e1059 = phi_1656_;
if _e1053 {
phi_1662_ = (~(_e1050) + select(0u, 1u, (_e1041 == 0u)));
} else {
phi_1662_ = _e1050;
}
let _e1063 = phi_1662_;
let _e1085 = ((((f32(bitcast<i32>(((_e1063 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1063 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1059 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1059 & 65535u)))));
let _e1091 = (_e975 + 4i);
let _e1093 = select(_e296, _e1091, (_e1091 < _e296));
let _e1099 = global_4.member[bitcast<u32>(select(0i, _e1093, (_e1093 > 0i)))];
let _e1100 = (_e975 + 5i);
let _e1102 = select(_e296, _e1100, (_e1100 < _e296));
let _e1108 = global_4.member[bitcast<u32>(select(0i, _e1102, (_e1102 > 0i)))];
let _e1111 = ((_e1108 >> bitcast<u32>(31i)) != 0u);
if _e1111 {
phi_1724_ = (~(_e1099) + 1u);
} else {
phi_1724_ = _e1099;
}
let _e1117 = phi_1724_;
if _e1111 {
phi_1730_ = (~(_e1108) + select(0u, 1u, (_e1099 == 0u)));
} else {
phi_1730_ = _e1108;
}
let _e1121 = phi_1730_;
let _e1143 = ((((f32(bitcast<i32>(((_e1121 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1121 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1117 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1117 & 65535u)))));
if _e565 {
phi_1829_ = 0u;
} else {
if (_e474 == 1u) {
phi_1828_ = _e552;
} else {
if (_e474 == 2u) {
phi_1827_ = _e556;
} else {
phi_1827_ = select(_e564, _e560, (_e474 == 3u));
}
let _e1157 = phi_1827_;
phi_1828_ = _e1157;
}
let _e1159 = phi_1828_;
phi_1829_ = _e1159;
}
let _e1161 = phi_1829_;
let _e1165 = (((bitcast<i32>(_e1161) + _e972) + _e762) * 6i);
let _e1167 = select(_e296, _e1165, (_e1165 < _e296));
let _e1173 = global_4.member[bitcast<u32>(select(0i, _e1167, (_e1167 > 0i)))];
let _e1174 = (_e1165 + 1i);
let _e1176 = select(_e296, _e1174, (_e1174 < _e296));
let _e1182 = global_4.member[bitcast<u32>(select(0i, _e1176, (_e1176 > 0i)))];
let _e1185 = ((_e1182 >> bitcast<u32>(31i)) != 0u);
if _e1185 {
phi_1888_ = (~(_e1173) + 1u);
} else {
phi_1888_ = _e1173;
}
let _e1191 = phi_1888_;
if _e1185 {
phi_1894_ = (~(_e1182) + select(0u, 1u, (_e1173 == 0u)));
} else {
phi_1894_ = _e1182;
}
let _e1195 = phi_1894_;
let _e1217 = ((((f32(bitcast<i32>(((_e1195 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1195 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1191 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1191 & 65535u)))));
let _e1223 = (_e1165 + 2i);
let _e1225 = select(_e296, _e1223, (_e1223 < _e296));
let _e1231 = global_4.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1232 = (_e1165 + 3i);
let _e1234 = select(_e296, _e1232, (_e1232 < _e296));
let _e1240 = global_4.member[bitcast<u32>(select(0i, _e1234, (_e1234 > 0i)))];
let _e1243 = ((_e1240 >> bitcast<u32>(31i)) != 0u);
if _e1243 {
phi_1956_ = (~(_e1231) + 1u);
} else {
phi_1956_ = _e1231;
}
let _e1249 = phi_1956_;
if _e1243 {
phi_1962_ = (~(_e1240) + select(0u, 1u, (_e1231 == 0u)));
} else {
phi_1962_ = _e1240;
}
let _e1253 = phi_1962_;
let _e1275 = ((((f32(bitcast<i32>(((_e1253 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1253 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1249 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1249 & 65535u)))));
let _e1281 = (_e1165 + 4i);
let _e1283 = select(_e296, _e1281, (_e1281 < _e296));
let _e1289 = global_4.member[bitcast<u32>(select(0i, _e1283, (_e1283 > 0i)))];
let _e1290 = (_e1165 + 5i);
let _e1292 = select(_e296, _e1290, (_e1290 < _e296));
let _e1298 = global_4.member[bitcast<u32>(select(0i, _e1292, (_e1292 > 0i)))];
let _e1301 = ((_e1298 >> bitcast<u32>(31i)) != 0u);
if _e1301 {
phi_2024_ = (~(_e1289) + 1u);
} else {
phi_2024_ = _e1289;
}
let _e1307 = phi_2024_;
if _e1301 {
phi_2030_ = (~(_e1298) + select(0u, 1u, (_e1289 == 0u)));
} else {
phi_2030_ = _e1298;
}
let _e1311 = phi_2030_;
let _e1333 = ((((f32(bitcast<i32>(((_e1311 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1311 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1307 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1307 & 65535u)))));
let _e1345 = (1f - _e526);
phi_782_ = vec3<f32>((_e472.x + ((((select(_e632, -(bitcast<f32>((bitcast<u32>(_e632) & 2147483647u))), _e600) * _e754) + (select(_e828, -(bitcast<f32>((bitcast<u32>(_e828) & 2147483647u))), _e796) * _e524)) * _e1345) + (((select(_e1027, -(bitcast<f32>((bitcast<u32>(_e1027) & 2147483647u))), _e995) * _e754) + (select(_e1217, -(bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u))), _e1185) * _e524)) * _e526))), (_e472.y + ((((select(_e690, -(bitcast<f32>((bitcast<u32>(_e690) & 2147483647u))), _e658) * _e754) + (select(_e886, -(bitcast<f32>((bitcast<u32>(_e886) & 2147483647u))), _e854) * _e524)) * _e1345) + (((select(_e1085, -(bitcast<f32>((bitcast<u32>(_e1085) & 2147483647u))), _e1053) * _e754) + (select(_e1275, -(bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u))), _e1243) * _e524)) * _e526))), (_e472.z + ((((select(_e748, -(bitcast<f32>((bitcast<u32>(_e748) & 2147483647u))), _e716) * _e754) + (select(_e944, -(bitcast<f32>((bitcast<u32>(_e944) & 2147483647u))), _e912) * _e524)) * _e1345) + (((select(_e1143, -(bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u))), _e1111) * _e754) + (select(_e1333, -(bitcast<f32>((bitcast<u32>(_e1333) & 2147483647u))), _e1301) * _e524)) * _e526))));
phi_785_ = (_e474 + 1u);
} else {
phi_782_ = vec3<f32>();
phi_785_ = u32();
}
let _e1364 = phi_782_;
let _e1366 = phi_785_;
continue;
continuing {
phi_781_ = _e1364;
phi_784_ = _e1366;
break if !(_e479);
}
}
let _e1371 = global_2.member.member_18.member;
let _e1372 = (1f / _e1371);
let _e1374 = local;
let _e1378 = local_1;
let _e1382 = local_2;
let _e1385 = ((_e1374.x * _e1372) + _e170);
let _e1386 = ((_e1378.y * _e1372) + _e181);
let _e1387 = ((_e1382.z * _e1372) + _e192);
let _e1389 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e1391 = select(_e1389, _e294, (_e294 < _e1389));
let _e1397 = global_5.member[bitcast<u32>(select(0i, _e1391, (_e1391 > 0i)))];
let _e1399 = select(_e1389, _e305, (_e305 < _e1389));
let _e1405 = global_5.member[bitcast<u32>(select(0i, _e1399, (_e1399 > 0i)))];
let _e1408 = ((_e1405 >> bitcast<u32>(31i)) != 0u);
if _e1408 {
phi_2223_ = (~(_e1397) + 1u);
} else {
phi_2223_ = _e1397;
}
let _e1414 = phi_2223_;
if _e1408 {
phi_2229_ = (~(_e1405) + select(0u, 1u, (_e1397 == 0u)));
} else {
phi_2229_ = _e1405;
}
let _e1418 = phi_2229_;
let _e1440 = ((((f32(bitcast<i32>(((_e1418 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1418 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1414 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1414 & 65535u)))));
let _e1447 = select(_e1389, _e354, (_e354 < _e1389));
let _e1453 = global_5.member[bitcast<u32>(select(0i, _e1447, (_e1447 > 0i)))];
let _e1455 = select(_e1389, _e363, (_e363 < _e1389));
let _e1461 = global_5.member[bitcast<u32>(select(0i, _e1455, (_e1455 > 0i)))];
let _e1464 = ((_e1461 >> bitcast<u32>(31i)) != 0u);
if _e1464 {
phi_2291_ = (~(_e1453) + 1u);
} else {
phi_2291_ = _e1453;
}
let _e1470 = phi_2291_;
if _e1464 {
phi_2297_ = (~(_e1461) + select(0u, 1u, (_e1453 == 0u)));
} else {
phi_2297_ = _e1461;
}
let _e1474 = phi_2297_;
let _e1496 = ((((f32(bitcast<i32>(((_e1474 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1474 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1470 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1470 & 65535u)))));
let _e1503 = select(_e1389, _e412, (_e412 < _e1389));
let _e1509 = global_5.member[bitcast<u32>(select(0i, _e1503, (_e1503 > 0i)))];
let _e1511 = select(_e1389, _e421, (_e421 < _e1389));
let _e1517 = global_5.member[bitcast<u32>(select(0i, _e1511, (_e1511 > 0i)))];
let _e1520 = ((_e1517 >> bitcast<u32>(31i)) != 0u);
if _e1520 {
phi_2359_ = (~(_e1509) + 1u);
} else {
phi_2359_ = _e1509;
}
let _e1526 = phi_2359_;
if _e1520 {
phi_2365_ = (~(_e1517) + select(0u, 1u, (_e1509 == 0u)));
} else {
phi_2365_ = _e1517;
}
let _e1530 = phi_2365_;
let _e1552 = ((((f32(bitcast<i32>(((_e1530 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1530 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1526 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1526 & 65535u)))));
phi_2388_ = vec3<f32>(select(_e1440, -(bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u))), _e1408), select(_e1496, -(bitcast<f32>((bitcast<u32>(_e1496) & 2147483647u))), _e1464), select(_e1552, -(bitcast<f32>((bitcast<u32>(_e1552) & 2147483647u))), _e1520));
phi_2391_ = 1u;
loop {
let _e1560 = phi_2388_;
let _e1562 = phi_2391_;
local_4 = _e1560;
local_5 = _e1560;
local_6 = _e1560;
let _e1564 = local_3;
let _e1565 = (_e1562 <= _e1564);
if _e1565 {
let _e1566 = (_e1562 & 31u);
let _e1570 = (1f / f32((1i << bitcast<u32>(_e1566))));
let _e1574 = (((f32(_e270) + 0.5f) * _e1570) - 0.5f);
let _e1578 = (((f32(_e271) + 0.5f) * _e1570) - 0.5f);
let _e1580 = select(-1f, _e1574, (_e1574 > -1f));
let _e1582 = select(1e6f, _e1580, (_e1580 < 1e6f));
let _e1589 = select(0i, select(select(i32(_e1582), i32(-2147483648), (_e1582 < -2147483600f)), 2147483647i, (_e1582 > 2147483500f)), (_e1582 == _e1582));
let _e1593 = (_e1589 - select(0i, 1i, (_e1582 < f32(_e1589))));
let _e1595 = select(-1f, _e1578, (_e1578 > -1f));
let _e1597 = select(1e6f, _e1595, (_e1595 < 1e6f));
let _e1604 = select(0i, select(select(i32(_e1597), i32(-2147483648), (_e1597 < -2147483600f)), 2147483647i, (_e1597 > 2147483500f)), (_e1597 == _e1597));
let _e1608 = (_e1604 - select(0i, 1i, (_e1597 < f32(_e1604))));
let _e1610 = (_e1574 - f32(_e1593));
let _e1612 = (_e1578 - f32(_e1608));
let _e1614 = (1u << bitcast<u32>(_e1566));
let _e1623 = bitcast<i32>((((_e275 + _e1614) - 1u) >> bitcast<u32>(_e1566)));
let _e1624 = (_e1623 - 1i);
let _e1626 = (bitcast<i32>((((_e279 + _e1614) - 1u) >> bitcast<u32>(_e1566))) - 1i);
let _e1628 = select(_e1624, _e1593, (_e1593 < _e1624));
let _e1630 = select(_e1626, _e1608, (_e1608 < _e1626));
let _e1632 = select(0i, _e1628, (_e1628 > 0i));
let _e1638 = global_2.member.member_18.member_2;
let _e1642 = global_2.member.member_18.member_3;
let _e1646 = global_2.member.member_18.member_4;
let _e1650 = global_2.member.member_18.member_5;
let _e1651 = (_e1562 == 0u);
if _e1651 {
phi_2536_ = 0u;
} else {
if (_e1562 == 1u) {
phi_2535_ = _e1638;
} else {
if (_e1562 == 2u) {
phi_2534_ = _e1642;
} else {
phi_2534_ = select(_e1650, _e1646, (_e1562 == 3u));
}
let _e1657 = phi_2534_;
phi_2535_ = _e1657;
}
let _e1659 = phi_2535_;
phi_2536_ = _e1659;
}
let _e1661 = phi_2536_;
let _e1663 = (select(0i, _e1630, (_e1630 > 0i)) * _e1623);
let _e1666 = (((bitcast<i32>(_e1661) + _e1663) + _e1632) * 6i);
let _e1668 = select(_e1389, _e1666, (_e1666 < _e1389));
let _e1674 = global_5.member[bitcast<u32>(select(0i, _e1668, (_e1668 > 0i)))];
let _e1675 = (_e1666 + 1i);
let _e1677 = select(_e1389, _e1675, (_e1675 < _e1389));
let _e1683 = global_5.member[bitcast<u32>(select(0i, _e1677, (_e1677 > 0i)))];
let _e1686 = ((_e1683 >> bitcast<u32>(31i)) != 0u);
if _e1686 {
phi_2595_ = (~(_e1674) + 1u);
} else {
phi_2595_ = _e1674;
}
let _e1692 = phi_2595_;
if _e1686 {
phi_2601_ = (~(_e1683) + select(0u, 1u, (_e1674 == 0u)));
} else {
phi_2601_ = _e1683;
}
let _e1696 = phi_2601_;
let _e1718 = ((((f32(bitcast<i32>(((_e1696 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1696 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1692 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1692 & 65535u)))));
let _e1724 = (_e1666 + 2i);
let _e1726 = select(_e1389, _e1724, (_e1724 < _e1389));
let _e1732 = global_5.member[bitcast<u32>(select(0i, _e1726, (_e1726 > 0i)))];
let _e1733 = (_e1666 + 3i);
let _e1735 = select(_e1389, _e1733, (_e1733 < _e1389));
let _e1741 = global_5.member[bitcast<u32>(select(0i, _e1735, (_e1735 > 0i)))];
let _e1744 = ((_e1741 >> bitcast<u32>(31i)) != 0u);
if _e1744 {
phi_2663_ = (~(_e1732) + 1u);
} else {
phi_2663_ = _e1732;
}
let _e1750 = phi_2663_;
if _e1744 {
phi_2669_ = (~(_e1741) + select(0u, 1u, (_e1732 == 0u)));
} else {
phi_2669_ = _e1741;
}
let _e1754 = phi_2669_;
let _e1776 = ((((f32(bitcast<i32>(((_e1754 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1754 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1750 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1750 & 65535u)))));
let _e1782 = (_e1666 + 4i);
let _e1784 = select(_e1389, _e1782, (_e1782 < _e1389));
let _e1790 = global_5.member[bitcast<u32>(select(0i, _e1784, (_e1784 > 0i)))];
let _e1791 = (_e1666 + 5i);
let _e1793 = select(_e1389, _e1791, (_e1791 < _e1389));
let _e1799 = global_5.member[bitcast<u32>(select(0i, _e1793, (_e1793 > 0i)))];
let _e1802 = ((_e1799 >> bitcast<u32>(31i)) != 0u);
if _e1802 {
phi_2731_ = (~(_e1790) + 1u);
} else {
phi_2731_ = _e1790;
}
let _e1808 = phi_2731_;
if _e1802 {
phi_2737_ = (~(_e1799) + select(0u, 1u, (_e1790 == 0u)));
} else {
phi_2737_ = _e1799;
}
let _e1812 = phi_2737_;
let _e1834 = ((((f32(bitcast<i32>(((_e1812 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1812 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1808 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1808 & 65535u)))));
let _e1840 = (1f - _e1610);
let _e1844 = (_e1593 + 1i);
let _e1846 = select(_e1624, _e1844, (_e1844 < _e1624));
let _e1848 = select(0i, _e1846, (_e1846 > 0i));
if _e1651 {
phi_2835_ = 0u;
} else {
if (_e1562 == 1u) {
phi_2834_ = _e1638;
} else {
if (_e1562 == 2u) {
phi_2833_ = _e1642;
} else {
phi_2833_ = select(_e1650, _e1646, (_e1562 == 3u));
}
let _e1854 = phi_2833_;
phi_2834_ = _e1854;
}
let _e1856 = phi_2834_;
phi_2835_ = _e1856;
}
let _e1858 = phi_2835_;
let _e1862 = (((bitcast<i32>(_e1858) + _e1663) + _e1848) * 6i);
let _e1864 = select(_e1389, _e1862, (_e1862 < _e1389));
let _e1870 = global_5.member[bitcast<u32>(select(0i, _e1864, (_e1864 > 0i)))];
let _e1871 = (_e1862 + 1i);
let _e1873 = select(_e1389, _e1871, (_e1871 < _e1389));
let _e1879 = global_5.member[bitcast<u32>(select(0i, _e1873, (_e1873 > 0i)))];
let _e1882 = ((_e1879 >> bitcast<u32>(31i)) != 0u);
if _e1882 {
phi_2894_ = (~(_e1870) + 1u);
} else {
phi_2894_ = _e1870;
}
let _e1888 = phi_2894_;
if _e1882 {
phi_2900_ = (~(_e1879) + select(0u, 1u, (_e1870 == 0u)));
} else {
phi_2900_ = _e1879;
}
let _e1892 = phi_2900_;
let _e1914 = ((((f32(bitcast<i32>(((_e1892 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1892 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1888 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1888 & 65535u)))));
let _e1920 = (_e1862 + 2i);
let _e1922 = select(_e1389, _e1920, (_e1920 < _e1389));
let _e1928 = global_5.member[bitcast<u32>(select(0i, _e1922, (_e1922 > 0i)))];
let _e1929 = (_e1862 + 3i);
let _e1931 = select(_e1389, _e1929, (_e1929 < _e1389));
let _e1937 = global_5.member[bitcast<u32>(select(0i, _e1931, (_e1931 > 0i)))];
let _e1940 = ((_e1937 >> bitcast<u32>(31i)) != 0u);
if _e1940 {
phi_2962_ = (~(_e1928) + 1u);
} else {
phi_2962_ = _e1928;
}
let _e1946 = phi_2962_;
if _e1940 {
phi_2968_ = (~(_e1937) + select(0u, 1u, (_e1928 == 0u)));
} else {
phi_2968_ = _e1937;
}
let _e1950 = phi_2968_;
let _e1972 = ((((f32(bitcast<i32>(((_e1950 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1950 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e1946 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e1946 & 65535u)))));
let _e1978 = (_e1862 + 4i);
let _e1980 = select(_e1389, _e1978, (_e1978 < _e1389));
let _e1986 = global_5.member[bitcast<u32>(select(0i, _e1980, (_e1980 > 0i)))];
let _e1987 = (_e1862 + 5i);
let _e1989 = select(_e1389, _e1987, (_e1987 < _e1389));
let _e1995 = global_5.member[bitcast<u32>(select(0i, _e1989, (_e1989 > 0i)))];
let _e1998 = ((_e1995 >> bitcast<u32>(31i)) != 0u);
if _e1998 {
phi_3030_ = (~(_e1986) + 1u);
} else {
phi_3030_ = _e1986;
}
let _e2004 = phi_3030_;
if _e1998 {
phi_3036_ = (~(_e1995) + select(0u, 1u, (_e1986 == 0u)));
} else {
phi_3036_ = _e1995;
}
let _e2008 = phi_3036_;
let _e2030 = ((((f32(bitcast<i32>(((_e2008 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2008 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2004 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2004 & 65535u)))));
let _e2042 = (_e1608 + 1i);
let _e2044 = select(_e1626, _e2042, (_e2042 < _e1626));
if _e1651 {
phi_3136_ = 0u;
} else {
if (_e1562 == 1u) {
phi_3135_ = _e1638;
} else {
if (_e1562 == 2u) {
phi_3134_ = _e1642;
} else {
phi_3134_ = select(_e1650, _e1646, (_e1562 == 3u));
}
let _e2052 = phi_3134_;
phi_3135_ = _e2052;
}
let _e2054 = phi_3135_;
phi_3136_ = _e2054;
}
let _e2056 = phi_3136_;
let _e2058 = (select(0i, _e2044, (_e2044 > 0i)) * _e1623);
let _e2061 = (((bitcast<i32>(_e2056) + _e2058) + _e1632) * 6i);
let _e2063 = select(_e1389, _e2061, (_e2061 < _e1389));
let _e2069 = global_5.member[bitcast<u32>(select(0i, _e2063, (_e2063 > 0i)))];
let _e2070 = (_e2061 + 1i);
let _e2072 = select(_e1389, _e2070, (_e2070 < _e1389));
let _e2078 = global_5.member[bitcast<u32>(select(0i, _e2072, (_e2072 > 0i)))];
let _e2081 = ((_e2078 >> bitcast<u32>(31i)) != 0u);
if _e2081 {
phi_3195_ = (~(_e2069) + 1u);
} else {
phi_3195_ = _e2069;
}
let _e2087 = phi_3195_;
if _e2081 {
phi_3201_ = (~(_e2078) + select(0u, 1u, (_e2069 == 0u)));
} else {
phi_3201_ = _e2078;
}
let _e2091 = phi_3201_;
let _e2113 = ((((f32(bitcast<i32>(((_e2091 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2091 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2087 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2087 & 65535u)))));
let _e2119 = (_e2061 + 2i);
let _e2121 = select(_e1389, _e2119, (_e2119 < _e1389));
let _e2127 = global_5.member[bitcast<u32>(select(0i, _e2121, (_e2121 > 0i)))];
let _e2128 = (_e2061 + 3i);
let _e2130 = select(_e1389, _e2128, (_e2128 < _e1389));
let _e2136 = global_5.member[bitcast<u32>(select(0i, _e2130, (_e2130 > 0i)))];
let _e2139 = ((_e2136 >> bitcast<u32>(31i)) != 0u);
if _e2139 {
phi_3263_ = (~(_e2127) + 1u);
} else {
phi_3263_ = _e2127;
}
let _e2145 = phi_3263_;
if _e2139 {
phi_3269_ = (~(_e2136) + select(0u, 1u, (_e2127 == 0u)));
} else {
phi_3269_ = _e2136;
}
let _e2149 = phi_3269_;
let _e2171 = ((((f32(bitcast<i32>(((_e2149 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2149 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2145 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2145 & 65535u)))));
let _e2177 = (_e2061 + 4i);
let _e2179 = select(_e1389, _e2177, (_e2177 < _e1389));
let _e2185 = global_5.member[bitcast<u32>(select(0i, _e2179, (_e2179 > 0i)))];
let _e2186 = (_e2061 + 5i);
let _e2188 = select(_e1389, _e2186, (_e2186 < _e1389));
let _e2194 = global_5.member[bitcast<u32>(select(0i, _e2188, (_e2188 > 0i)))];
let _e2197 = ((_e2194 >> bitcast<u32>(31i)) != 0u);
if _e2197 {
phi_3331_ = (~(_e2185) + 1u);
} else {
phi_3331_ = _e2185;
}
let _e2203 = phi_3331_;
if _e2197 {
phi_3337_ = (~(_e2194) + select(0u, 1u, (_e2185 == 0u)));
} else {
phi_3337_ = _e2194;
}
let _e2207 = phi_3337_;
let _e2229 = ((((f32(bitcast<i32>(((_e2207 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2207 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2203 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2203 & 65535u)))));
if _e1651 {
phi_3436_ = 0u;
} else {
if (_e1562 == 1u) {
phi_3435_ = _e1638;
} else {
if (_e1562 == 2u) {
phi_3434_ = _e1642;
} else {
phi_3434_ = select(_e1650, _e1646, (_e1562 == 3u));
}
let _e2243 = phi_3434_;
phi_3435_ = _e2243;
}
let _e2245 = phi_3435_;
phi_3436_ = _e2245;
}
let _e2247 = phi_3436_;
let _e2251 = (((bitcast<i32>(_e2247) + _e2058) + _e1848) * 6i);
let _e2253 = select(_e1389, _e2251, (_e2251 < _e1389));
let _e2259 = global_5.member[bitcast<u32>(select(0i, _e2253, (_e2253 > 0i)))];
let _e2260 = (_e2251 + 1i);
let _e2262 = select(_e1389, _e2260, (_e2260 < _e1389));
let _e2268 = global_5.member[bitcast<u32>(select(0i, _e2262, (_e2262 > 0i)))];
let _e2271 = ((_e2268 >> bitcast<u32>(31i)) != 0u);
if _e2271 {
phi_3495_ = (~(_e2259) + 1u);
} else {
phi_3495_ = _e2259;
}
let _e2277 = phi_3495_;
if _e2271 {
phi_3501_ = (~(_e2268) + select(0u, 1u, (_e2259 == 0u)));
} else {
phi_3501_ = _e2268;
}
let _e2281 = phi_3501_;
let _e2303 = ((((f32(bitcast<i32>(((_e2281 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2281 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2277 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2277 & 65535u)))));
let _e2309 = (_e2251 + 2i);
let _e2311 = select(_e1389, _e2309, (_e2309 < _e1389));
let _e2317 = global_5.member[bitcast<u32>(select(0i, _e2311, (_e2311 > 0i)))];
let _e2318 = (_e2251 + 3i);
let _e2320 = select(_e1389, _e2318, (_e2318 < _e1389));
let _e2326 = global_5.member[bitcast<u32>(select(0i, _e2320, (_e2320 > 0i)))];
let _e2329 = ((_e2326 >> bitcast<u32>(31i)) != 0u);
if _e2329 {
phi_3563_ = (~(_e2317) + 1u);
} else {
phi_3563_ = _e2317;
}
let _e2335 = phi_3563_;
if _e2329 {
phi_3569_ = (~(_e2326) + select(0u, 1u, (_e2317 == 0u)));
} else {
phi_3569_ = _e2326;
}
let _e2339 = phi_3569_;
let _e2361 = ((((f32(bitcast<i32>(((_e2339 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2339 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2335 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2335 & 65535u)))));
let _e2367 = (_e2251 + 4i);
let _e2369 = select(_e1389, _e2367, (_e2367 < _e1389));
let _e2375 = global_5.member[bitcast<u32>(select(0i, _e2369, (_e2369 > 0i)))];
let _e2376 = (_e2251 + 5i);
let _e2378 = select(_e1389, _e2376, (_e2376 < _e1389));
let _e2384 = global_5.member[bitcast<u32>(select(0i, _e2378, (_e2378 > 0i)))];
let _e2387 = ((_e2384 >> bitcast<u32>(31i)) != 0u);
if _e2387 {
phi_3631_ = (~(_e2375) + 1u);
} else {
phi_3631_ = _e2375;
}
let _e2393 = phi_3631_;
if _e2387 {
phi_3637_ = (~(_e2384) + select(0u, 1u, (_e2375 == 0u)));
} else {
phi_3637_ = _e2384;
}
let _e2397 = phi_3637_;
let _e2419 = ((((f32(bitcast<i32>(((_e2397 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2397 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e2393 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e2393 & 65535u)))));
let _e2431 = (1f - _e1612);
phi_2389_ = vec3<f32>((_e1560.x + ((((select(_e1718, -(bitcast<f32>((bitcast<u32>(_e1718) & 2147483647u))), _e1686) * _e1840) + (select(_e1914, -(bitcast<f32>((bitcast<u32>(_e1914) & 2147483647u))), _e1882) * _e1610)) * _e2431) + (((select(_e2113, -(bitcast<f32>((bitcast<u32>(_e2113) & 2147483647u))), _e2081) * _e1840) + (select(_e2303, -(bitcast<f32>((bitcast<u32>(_e2303) & 2147483647u))), _e2271) * _e1610)) * _e1612))), (_e1560.y + ((((select(_e1776, -(bitcast<f32>((bitcast<u32>(_e1776) & 2147483647u))), _e1744) * _e1840) + (select(_e1972, -(bitcast<f32>((bitcast<u32>(_e1972) & 2147483647u))), _e1940) * _e1610)) * _e2431) + (((select(_e2171, -(bitcast<f32>((bitcast<u32>(_e2171) & 2147483647u))), _e2139) * _e1840) + (select(_e2361, -(bitcast<f32>((bitcast<u32>(_e2361) & 2147483647u))), _e2329) * _e1610)) * _e1612))), (_e1560.z + ((((select(_e1834, -(bitcast<f32>((bitcast<u32>(_e1834) & 2147483647u))), _e1802) * _e1840) + (select(_e2030, -(bitcast<f32>((bitcast<u32>(_e2030) & 2147483647u))), _e1998) * _e1610)) * _e2431) + (((select(_e2229, -(bitcast<f32>((bitcast<u32>(_e2229) & 2147483647u))), _e2197) * _e1840) + (select(_e2419, -(bitcast<f32>((bitcast<u32>(_e2419) & 2147483647u))), _e2387) * _e1610)) * _e1612))));
phi_2392_ = (_e1562 + 1u);
} else {
phi_2389_ = vec3<f32>();
phi_2392_ = u32();
}
let _e2450 = phi_2389_;
let _e2452 = phi_2392_;
continue;
continuing {
phi_2388_ = _e2450;
phi_2391_ = _e2452;
break if !(_e1565);
}
}
let _e2455 = local_4;
let _e2459 = local_5;
let _e2463 = local_6;
let _e2466 = ((_e2455.x * _e1372) + _e203);
let _e2467 = ((_e2459.y * _e1372) + _e214);
let _e2468 = ((_e2463.z * _e1372) + _e225);
let _e2469 = (_e137 - _e2466);
let _e2470 = (_e148 - _e2467);
let _e2471 = (_e159 - _e2468);
let _e2489 = global_2.member.member_2.member;
let _e2490 = (((((f32(_e270) + 0.5f) / f32(_e280)) * 2f) - 1f) * _e2489);
let _e2498 = global_2.member.member_2.member_1;
let _e2499 = ((1f - (((f32(_e271) + 0.5f) / f32(_e282)) * 2f)) * _e2498);
let _e2502 = global_2.member.member_3;
let _e2511 = global_2.member.member_4;
let _e2524 = global_2.member.member_2.member_3;
let _e2525 = (_e2524 != 0u);
let _e2528 = global_2.member.member_5;
let _e2535 = select((_e2528.member + ((_e2502.member * _e2490) + (_e2511.member * _e2499))), _e2528.member, _e2525);
let _e2536 = select((_e2528.member_1 + ((_e2502.member_1 * _e2490) + (_e2511.member_1 * _e2499))), _e2528.member_1, _e2525);
let _e2537 = select((_e2528.member_2 + ((_e2502.member_2 * _e2490) + (_e2511.member_2 * _e2499))), _e2528.member_2, _e2525);
let _e2547 = (((_e2535 * _e2535) + (_e2536 * _e2536)) + (_e2537 * _e2537));
let _e2575 = select(0f, _e236, (_e236 > 0f));
let _e2583 = global_2.member.member_7;
global_1.member[_e71] = ((_e104 + select(0f, _e2469, (_e2469 > 0f))) + _e1385);
global_1.member[(_e69 + _e71)] = ((_e115 + select(0f, _e2470, (_e2470 > 0f))) + _e1386);
global_1.member[((2u * _e69) + _e71)] = ((_e126 + select(0f, _e2471, (_e2471 > 0f))) + _e1387);
global_1.member[((3u * _e69) + _e71)] = select(1f, _e2575, (_e2575 < 1f));
global_1.member[((4u * _e69) + _e71)] = _e104;
global_1.member[((5u * _e69) + _e71)] = _e115;
global_1.member[((6u * _e69) + _e71)] = _e126;
global_1.member[((7u * _e69) + _e71)] = _e137;
global_1.member[((8u * _e69) + _e71)] = _e148;
global_1.member[((9u * _e69) + _e71)] = _e159;
global_1.member[((10u * _e69) + _e71)] = _e1385;
global_1.member[((11u * _e69) + _e71)] = _e1386;
global_1.member[((12u * _e69) + _e71)] = _e1387;
global_1.member[((13u * _e69) + _e71)] = _e2466;
global_1.member[((14u * _e69) + _e71)] = _e2467;
global_1.member[((15u * _e69) + _e71)] = _e2468;
global_1.member[((16u * _e69) + _e71)] = select(0f, ((_e93 * ((((_e2528.member * _e2535) + (_e2528.member_1 * _e2536)) + (_e2528.member_2 * _e2537)) / sqrt(select(0f, _e2547, (_e2547 > 0f))))) * _e2583), (_e93 < (0.5f * 1e30f)));
global_1.member[((17u * _e69) + _e71)] = (((_e2502.member * _e247) + (_e2502.member_1 * _e258)) + (_e2502.member_2 * _e269));
global_1.member[((18u * _e69) + _e71)] = (((_e2511.member * _e247) + (_e2511.member_1 * _e258)) + (_e2511.member_2 * _e269));
global_1.member[((19u * _e69) + _e71)] = -((((_e2528.member * _e247) + (_e2528.member_1 * _e258)) + (_e2528.member_2 * _e269)));
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
