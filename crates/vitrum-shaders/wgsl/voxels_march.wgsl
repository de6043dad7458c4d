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
struct type_12 {
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_5,
member_21: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: vec3<f32>,
member_14: i32,
member_15: i32,
member_16: i32,
member_17: f32,
}
struct type_22 {
member: array<u32>,
}
struct type_25 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(3)
var<storage> global_2: type_16;
@group(0) @binding(4)
var<storage, read_write> global_3: type_16;
@group(0) @binding(1)
var<storage> global_4: type_22;
@group(0) @binding(2)
var<storage> global_5: type_22;
@group(0) @binding(5)
var<storage, read_write> global_6: type_25;
fn function_() {
var local: i32;
var local_1: vec3<f32>;
var phi_788_: u32;
var phi_884_: i32;
var phi_887_: i32;
var phi_1323_: f32;
var phi_885_: i32;
var phi_888_: i32;
var local_2: i32;
var phi_1331_: type_20;
var phi_1333_: type_20;
var phi_1336_: i32;
var phi_1672_: f32;
var phi_1710_: i32;
var phi_1713_: i32;
var phi_2149_: f32;
var phi_1711_: i32;
var phi_1714_: i32;
var local_3: i32;
var phi_2161_: i32;
var phi_2164_: f32;
var phi_2166_: f32;
var phi_2195_: i32;
var phi_2198_: i32;
var phi_2634_: f32;
var phi_2196_: i32;
var phi_2199_: i32;
var local_4: i32;
var phi_2162_: i32;
var phi_2165_: f32;
var phi_2167_: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var phi_2669_: i32;
var phi_2672_: i32;
var phi_3108_: f32;
var phi_2670_: i32;
var phi_2673_: i32;
var local_8: i32;
var local_9: i32;
var phi_3568_: f32;
var phi_4007_: f32;
var phi_4447_: f32;
var phi_4886_: f32;
var phi_5326_: f32;
var phi_5765_: f32;
var local_10: f32;
var local_11: i32;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var phi_6095_: type_20;
var local_17: i32;
var local_18: i32;
var phi_6312_: type_20;
var phi_6710_: i32;
var phi_6712_: i32;
var phi_6740_: type_20;
var phi_6741_: type_20;
var phi_6821_: type_20;
var phi_6822_: type_20;
var phi_6840_: type_20;
var local_19: i32;
var phi_7288_: type_20;
var phi_7289_: type_20;
var phi_7267_: type_20;
var phi_7290_: type_20;
var local_20: i32;
var phi_7298_: type_20;
var phi_7299_: type_20;
var phi_7300_: bool;
var phi_7879_: type_20;
var local_21: i32;
var phi_8181_: type_20;
var phi_8182_: type_20;
var phi_8183_: type_20;
var phi_7590_: type_20;
var phi_8184_: type_20;
var phi_1334_: type_20;
var phi_1337_: i32;
var local_22: type_20;
var local_23: type_20;
var local_24: type_20;
var local_25: type_20;
var local_26: type_20;
var local_27: type_20;
var local_28: type_20;
var local_29: type_20;
var local_30: type_20;
var local_31: type_20;
var local_32: type_20;
var local_33: type_20;
var local_34: type_20;
var local_35: type_20;
var local_36: type_20;
var local_37: type_20;
var local_38: type_20;
var local_39: type_20;
var local_40: type_20;
var local_41: type_20;
var local_42: type_20;
var local_43: type_20;
var local_44: type_20;
var local_45: type_20;
var local_46: type_20;
var local_47: type_20;
var local_48: type_20;
var local_49: type_20;
var local_50: type_20;
var local_51: type_20;
var local_52: type_20;
var local_53: f32;
let _e95 = global;
let _e101 = arrayLength((&global_5.member));
let _e103 = arrayLength((&global_2.member));
let _e110 = global_1.member.member;
if (_e95.x < _e110.member) {
if (_e95.y < _e110.member_1) {
let _e117 = (_e110.member * _e110.member_1);
let _e119 = ((_e95.y * _e110.member) + _e95.x);
let _e120 = bitcast<i32>(_e119);
let _e122 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e124 = select(_e122, _e120, (_e120 < _e122));
let _e130 = global_3.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e131 = (_e117 + _e119);
let _e132 = bitcast<i32>(_e131);
let _e134 = select(_e122, _e132, (_e132 < _e122));
let _e140 = global_3.member[bitcast<u32>(select(0i, _e134, (_e134 > 0i)))];
let _e142 = ((2u * _e117) + _e119);
let _e143 = bitcast<i32>(_e142);
let _e145 = select(_e122, _e143, (_e143 < _e122));
let _e151 = global_3.member[bitcast<u32>(select(0i, _e145, (_e145 > 0i)))];
let _e153 = ((3u * _e117) + _e119);
let _e154 = bitcast<i32>(_e153);
let _e156 = select(_e122, _e154, (_e154 < _e122));
let _e162 = global_3.member[bitcast<u32>(select(0i, _e156, (_e156 > 0i)))];
let _e164 = ((4u * _e117) + _e119);
let _e165 = bitcast<i32>(_e164);
let _e167 = select(_e122, _e165, (_e165 < _e122));
let _e173 = global_3.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e175 = ((5u * _e117) + _e119);
let _e176 = bitcast<i32>(_e175);
let _e178 = select(_e122, _e176, (_e176 < _e122));
let _e184 = global_3.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = ((6u * _e117) + _e119);
let _e187 = bitcast<i32>(_e186);
let _e189 = select(_e122, _e187, (_e187 < _e122));
let _e195 = global_3.member[bitcast<u32>(select(0i, _e189, (_e189 > 0i)))];
let _e197 = ((7u * _e117) + _e119);
let _e198 = bitcast<i32>(_e197);
let _e200 = select(_e122, _e198, (_e198 < _e122));
let _e206 = global_3.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e208 = ((8u * _e117) + _e119);
let _e209 = bitcast<i32>(_e208);
let _e211 = select(_e122, _e209, (_e209 < _e122));
let _e217 = global_3.member[bitcast<u32>(select(0i, _e211, (_e211 > 0i)))];
let _e219 = ((9u * _e117) + _e119);
let _e220 = bitcast<i32>(_e219);
let _e222 = select(_e122, _e220, (_e220 < _e122));
let _e228 = global_3.member[bitcast<u32>(select(0i, _e222, (_e222 > 0i)))];
let _e230 = ((10u * _e117) + _e119);
let _e231 = bitcast<i32>(_e230);
let _e233 = select(_e122, _e231, (_e231 < _e122));
let _e239 = global_3.member[bitcast<u32>(select(0i, _e233, (_e233 > 0i)))];
let _e241 = ((11u * _e117) + _e119);
let _e242 = bitcast<i32>(_e241);
let _e244 = select(_e122, _e242, (_e242 < _e122));
let _e250 = global_3.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e252 = ((12u * _e117) + _e119);
let _e253 = bitcast<i32>(_e252);
let _e255 = select(_e122, _e253, (_e253 < _e122));
let _e261 = global_3.member[bitcast<u32>(select(0i, _e255, (_e255 > 0i)))];
let _e263 = ((13u * _e117) + _e119);
let _e264 = bitcast<i32>(_e263);
let _e266 = select(_e122, _e264, (_e264 < _e122));
let _e272 = global_3.member[bitcast<u32>(select(0i, _e266, (_e266 > 0i)))];
let _e274 = ((14u * _e117) + _e119);
let _e275 = bitcast<i32>(_e274);
let _e277 = select(_e122, _e275, (_e275 < _e122));
let _e283 = global_3.member[bitcast<u32>(select(0i, _e277, (_e277 > 0i)))];
let _e285 = ((15u * _e117) + _e119);
let _e286 = bitcast<i32>(_e285);
let _e288 = select(_e122, _e286, (_e286 < _e122));
let _e294 = global_3.member[bitcast<u32>(select(0i, _e288, (_e288 > 0i)))];
let _e296 = ((16u * _e117) + _e119);
let _e297 = bitcast<i32>(_e296);
let _e299 = select(_e122, _e297, (_e297 < _e122));
let _e305 = global_3.member[bitcast<u32>(select(0i, _e299, (_e299 > 0i)))];
let _e307 = ((17u * _e117) + _e119);
let _e308 = bitcast<i32>(_e307);
let _e310 = select(_e122, _e308, (_e308 < _e122));
let _e316 = global_3.member[bitcast<u32>(select(0i, _e310, (_e310 > 0i)))];
let _e318 = ((18u * _e117) + _e119);
let _e319 = bitcast<i32>(_e318);
let _e321 = select(_e122, _e319, (_e319 < _e122));
let _e327 = global_3.member[bitcast<u32>(select(0i, _e321, (_e321 > 0i)))];
let _e329 = ((19u * _e117) + _e119);
let _e330 = bitcast<i32>(_e329);
let _e332 = select(_e122, _e330, (_e330 < _e122));
let _e338 = global_3.member[bitcast<u32>(select(0i, _e332, (_e332 > 0i)))];
let _e340 = ((20u * _e117) + _e119);
let _e341 = bitcast<i32>(_e340);
let _e343 = select(_e122, _e341, (_e341 < _e122));
let _e349 = global_3.member[bitcast<u32>(select(0i, _e343, (_e343 > 0i)))];
let _e351 = ((21u * _e117) + _e119);
let _e352 = bitcast<i32>(_e351);
let _e354 = select(_e122, _e352, (_e352 < _e122));
let _e360 = global_3.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e362 = ((22u * _e117) + _e119);
let _e363 = bitcast<i32>(_e362);
let _e365 = select(_e122, _e363, (_e363 < _e122));
let _e371 = global_3.member[bitcast<u32>(select(0i, _e365, (_e365 > 0i)))];
let _e373 = ((23u * _e117) + _e119);
let _e374 = bitcast<i32>(_e373);
let _e376 = select(_e122, _e374, (_e374 < _e122));
let _e382 = global_3.member[bitcast<u32>(select(0i, _e376, (_e376 > 0i)))];
let _e384 = ((24u * _e117) + _e119);
let _e385 = bitcast<i32>(_e384);
let _e387 = select(_e122, _e385, (_e385 < _e122));
let _e393 = global_3.member[bitcast<u32>(select(0i, _e387, (_e387 > 0i)))];
let _e395 = ((25u * _e117) + _e119);
let _e396 = bitcast<i32>(_e395);
let _e398 = select(_e122, _e396, (_e396 < _e122));
let _e404 = global_3.member[bitcast<u32>(select(0i, _e398, (_e398 > 0i)))];
let _e406 = ((26u * _e117) + _e119);
let _e407 = bitcast<i32>(_e406);
let _e409 = select(_e122, _e407, (_e407 < _e122));
let _e415 = global_3.member[bitcast<u32>(select(0i, _e409, (_e409 > 0i)))];
let _e417 = ((27u * _e117) + _e119);
let _e418 = bitcast<i32>(_e417);
let _e420 = select(_e122, _e418, (_e418 < _e122));
let _e426 = global_3.member[bitcast<u32>(select(0i, _e420, (_e420 > 0i)))];
let _e428 = ((28u * _e117) + _e119);
let _e429 = bitcast<i32>(_e428);
let _e431 = select(_e122, _e429, (_e429 < _e122));
let _e437 = global_3.member[bitcast<u32>(select(0i, _e431, (_e431 > 0i)))];
let _e439 = ((29u * _e117) + _e119);
let _e440 = bitcast<i32>(_e439);
let _e442 = select(_e122, _e440, (_e440 < _e122));
let _e448 = global_3.member[bitcast<u32>(select(0i, _e442, (_e442 > 0i)))];
let _e450 = ((30u * _e117) + _e119);
let _e451 = bitcast<i32>(_e450);
let _e453 = select(_e122, _e451, (_e451 < _e122));
let _e459 = global_3.member[bitcast<u32>(select(0i, _e453, (_e453 > 0i)))];
let _e461 = ((31u * _e117) + _e119);
let _e462 = bitcast<i32>(_e461);
let _e464 = select(_e122, _e462, (_e462 < _e122));
let _e470 = global_3.member[bitcast<u32>(select(0i, _e464, (_e464 > 0i)))];
let _e471 = (_e305 == 0f);
if _e471 {
phi_788_ = 3u;
} else {
phi_788_ = select(0u, 1u, (_e305 == 4f));
}
let _e475 = phi_788_;
if (_e475 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e484 = atomicLoad((&global_6.member[0u]));
if (_e484 == 0u) {
atomicStore((&global_6.member[0u]), ((_e110.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e110.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e475 > 1u) {
let _e492 = vec3<f32>(_e130, _e140, _e151);
let _e493 = vec3<f32>(_e162, _e173, _e184);
let _e494 = vec3<f32>(_e195, _e206, _e217);
let _e495 = vec3<f32>(_e228, _e239, _e250);
let _e496 = vec3<f32>(_e261, _e272, _e283);
let _e504 = vec3<f32>(_e371, _e382, _e393);
let _e505 = vec3<f32>(_e404, _e415, _e426);
let _e512 = select(0i, select(select(i32(_e437), i32(-2147483648), (_e437 < -2147483600f)), 2147483647i, (_e437 > 2147483500f)), (_e437 == _e437));
let _e519 = select(0i, select(select(i32(_e448), i32(-2147483648), (_e448 < -2147483600f)), 2147483647i, (_e448 > 2147483500f)), (_e448 == _e448));
let _e526 = select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < -2147483600f)), 2147483647i, (_e459 > 2147483500f)), (_e459 == _e459));
let _e530 = global_1.member.member_14;
let _e536 = global_1.member.member_15;
if (_e471 && (_e327 == 0f)) {
let _e544 = global_1.member.member_3;
phi_884_ = (bitcast<i32>(_e544) - 1i);
phi_887_ = 16i;
loop {
let _e548 = phi_884_;
let _e550 = phi_887_;
local_2 = _e550;
let _e551 = (_e548 >= 0i);
if _e551 {
let _e555 = global_1.member.member_2.member;
let _e560 = global_1.member.member_2.member_1;
let _e565 = global_1.member.member_2.member_2;
let _e567 = (_e130 - 0.5f);
let _e568 = (_e140 - 0.5f);
let _e569 = (_e151 - 0.5f);
let _e571 = f32((bitcast<i32>(_e555) - 2i));
let _e573 = select(0f, _e567, (_e567 > 0f));
let _e575 = select(_e571, _e573, (_e573 < _e571));
let _e582 = select(0i, select(select(i32(_e575), i32(-2147483648), (_e575 < -2147483600f)), 2147483647i, (_e575 > 2147483500f)), (_e575 == _e575));
let _e586 = (_e582 - select(0i, 1i, (_e575 < f32(_e582))));
let _e588 = f32((bitcast<i32>(_e560) - 2i));
let _e590 = select(0f, _e568, (_e568 > 0f));
let _e592 = select(_e588, _e590, (_e590 < _e588));
let _e599 = select(0i, select(select(i32(_e592), i32(-2147483648), (_e592 < -2147483600f)), 2147483647i, (_e592 > 2147483500f)), (_e592 == _e592));
let _e603 = (_e599 - select(0i, 1i, (_e592 < f32(_e599))));
let _e605 = f32((bitcast<i32>(_e565) - 2i));
let _e607 = select(0f, _e569, (_e569 > 0f));
let _e609 = select(_e605, _e607, (_e607 < _e605));
let _e616 = select(0i, select(select(i32(_e609), i32(-2147483648), (_e609 < -2147483600f)), 2147483647i, (_e609 > 2147483500f)), (_e609 == _e609));
let _e620 = (_e616 - select(0i, 1i, (_e609 < f32(_e616))));
let _e621 = (_e548 * 4i);
let _e622 = (_e621 + 1i);
let _e624 = (bitcast<i32>(_e101) - 1i);
let _e626 = select(_e624, _e622, (_e622 < _e624));
let _e632 = global_5.member[bitcast<u32>(select(0i, _e626, (_e626 > 0i)))];
let _e633 = (_e621 + 2i);
let _e635 = select(_e624, _e633, (_e633 < _e624));
let _e641 = global_5.member[bitcast<u32>(select(0i, _e635, (_e635 > 0i)))];
let _e642 = (_e621 + 3i);
let _e644 = select(_e624, _e642, (_e642 < _e624));
let _e650 = global_5.member[bitcast<u32>(select(0i, _e644, (_e644 > 0i)))];
let _e653 = (_e586 - bitcast<i32>((_e632 & 65535u)));
let _e658 = bitcast<i32>((_e632 >> bitcast<u32>(16i)));
let _e663 = (_e603 - bitcast<i32>((_e641 & 65535u)));
let _e668 = bitcast<i32>((_e641 >> bitcast<u32>(16i)));
let _e673 = (_e620 - bitcast<i32>((_e650 & 65535u)));
if ((((_e653 >= 0i) && ((_e653 + 1i) < _e658)) && ((_e663 >= 0i) && ((_e663 + 1i) < _e668))) && ((_e673 >= 0i) && ((_e673 + 1i) < bitcast<i32>((_e650 >> bitcast<u32>(16i)))))) {
let _e683 = (_e668 * _e658);
let _e685 = select(_e624, _e621, (_e621 < _e624));
let _e691 = global_5.member[bitcast<u32>(select(0i, _e685, (_e685 > 0i)))];
let _e697 = (((bitcast<i32>(_e691) + (_e673 * _e683)) + (_e663 * _e658)) + _e653);
let _e699 = (_e567 - f32(_e586));
let _e701 = (_e568 - f32(_e603));
let _e704 = (2i * _e697);
let _e706 = (_e704 >> bitcast<u32>(2i));
let _e709 = bitcast<u32>(((_e704 & 3i) * 8i));
let _e711 = select(_e624, _e706, (_e706 < _e624));
let _e717 = global_5.member[bitcast<u32>(select(0i, _e711, (_e711 > 0i)))];
let _e721 = (_e706 + 1i);
let _e723 = select(_e624, _e721, (_e721 < _e624));
let _e729 = global_5.member[bitcast<u32>(select(0i, _e723, (_e723 > 0i)))];
let _e736 = ((_e717 >> bitcast<u32>((_e709 & 31u))) | ((_e729 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e709) & 31u))));
let _e739 = f32(bitcast<i32>((_e736 & 65535u)));
let _e746 = (_e739 + ((f32(bitcast<i32>((_e736 >> bitcast<u32>(16i)))) - _e739) * _e699));
let _e748 = (2i * (_e697 + _e658));
let _e750 = (_e748 >> bitcast<u32>(2i));
let _e753 = bitcast<u32>(((_e748 & 3i) * 8i));
let _e755 = select(_e624, _e750, (_e750 < _e624));
let _e761 = global_5.member[bitcast<u32>(select(0i, _e755, (_e755 > 0i)))];
let _e765 = (_e750 + 1i);
let _e767 = select(_e624, _e765, (_e765 < _e624));
let _e773 = global_5.member[bitcast<u32>(select(0i, _e767, (_e767 > 0i)))];
let _e780 = ((_e761 >> bitcast<u32>((_e753 & 31u))) | ((_e773 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e753) & 31u))));
let _e783 = f32(bitcast<i32>((_e780 & 65535u)));
let _e791 = (_e697 + _e683);
let _e792 = (2i * _e791);
let _e794 = (_e792 >> bitcast<u32>(2i));
let _e797 = bitcast<u32>(((_e792 & 3i) * 8i));
let _e799 = select(_e624, _e794, (_e794 < _e624));
let _e805 = global_5.member[bitcast<u32>(select(0i, _e799, (_e799 > 0i)))];
let _e809 = (_e794 + 1i);
let _e811 = select(_e624, _e809, (_e809 < _e624));
let _e817 = global_5.member[bitcast<u32>(select(0i, _e811, (_e811 > 0i)))];
let _e824 = ((_e805 >> bitcast<u32>((_e797 & 31u))) | ((_e817 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e797) & 31u))));
let _e827 = f32(bitcast<i32>((_e824 & 65535u)));
let _e834 = (_e827 + ((f32(bitcast<i32>((_e824 >> bitcast<u32>(16i)))) - _e827) * _e699));
let _e836 = (2i * (_e791 + _e658));
let _e838 = (_e836 >> bitcast<u32>(2i));
let _e841 = bitcast<u32>(((_e836 & 3i) * 8i));
let _e843 = select(_e624, _e838, (_e838 < _e624));
let _e849 = global_5.member[bitcast<u32>(select(0i, _e843, (_e843 > 0i)))];
let _e853 = (_e838 + 1i);
let _e855 = select(_e624, _e853, (_e853 < _e624));
let _e861 = global_5.member[bitcast<u32>(select(0i, _e855, (_e855 > 0i)))];
let _e868 = ((_e849 >> bitcast<u32>((_e841 & 31u))) | ((_e861 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e841) & 31u))));
let _e871 = f32(bitcast<i32>((_e868 & 65535u)));
let _e881 = (_e746 + (((_e783 + ((f32(bitcast<i32>((_e780 >> bitcast<u32>(16i)))) - _e783) * _e699)) - _e746) * _e701));
phi_1323_ = (_e881 + (((_e834 + (((_e871 + ((f32(bitcast<i32>((_e868 >> bitcast<u32>(16i)))) - _e871) * _e699)) - _e834) * _e701)) - _e881) * (_e569 - f32(_e620))));
} else {
phi_1323_ = 0f;
}
let _e889 = phi_1323_;
phi_885_ = (_e548 - 1i);
phi_888_ = select(_e550, _e548, (_e889 > 32767.5f));
} else {
phi_885_ = i32();
phi_888_ = i32();
}
let _e894 = phi_885_;
let _e896 = phi_888_;
continue;
continuing {
phi_884_ = _e894;
phi_887_ = _e896;
break if !(_e551);
}
}
let _e899 = local_2;
phi_1331_ = type_20(_e492, _e493, _e494, _e495, _e496, _e294, _e305, _e899, _e327, _e338, _e349, _e360, _e504, _e505, _e512, _e519, _e526, _e470);
} else {
phi_1331_ = type_20(_e492, _e493, _e494, _e495, _e496, _e294, _e305, select(0i, select(select(i32(_e316), i32(-2147483648), (_e316 < -2147483600f)), 2147483647i, (_e316 > 2147483500f)), (_e316 == _e316)), _e327, _e338, _e349, _e360, _e504, _e505, _e512, _e519, _e526, _e470);
}
let _e902 = phi_1331_;
phi_1333_ = _e902;
phi_1336_ = 0i;
loop {
let _e904 = phi_1333_;
let _e906 = phi_1336_;
local_22 = _e904;
local_23 = _e904;
local_24 = _e904;
local_25 = _e904;
local_26 = _e904;
local_27 = _e904;
local_28 = _e904;
local_29 = _e904;
local_30 = _e904;
local_31 = _e904;
local_32 = _e904;
local_33 = _e904;
local_34 = _e904;
local_35 = _e904;
local_36 = _e904;
local_37 = _e904;
local_38 = _e904;
local_39 = _e904;
local_40 = _e904;
local_41 = _e904;
local_42 = _e904;
local_43 = _e904;
local_44 = _e904;
local_45 = _e904;
local_46 = _e904;
local_47 = _e904;
local_48 = _e904;
local_49 = _e904;
local_50 = _e904;
local_51 = _e904;
local_52 = _e904;
let _e910 = ((_e906 < 256i) && (_e904.member_6 == 0f));
local_53 = _e904.member_6;
if _e910 {
let _e921 = (1f / select(_e904.member_1.x, select(1e-12f, -1e-12f, (_e904.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e904.member_1.x) & 2147483647u)) < 1e-12f)));
let _e930 = (1f / select(_e904.member_1.y, select(1e-12f, -1e-12f, (_e904.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e904.member_1.y) & 2147483647u)) < 1e-12f)));
let _e939 = (1f / select(_e904.member_1.z, select(1e-12f, -1e-12f, (_e904.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e904.member_1.z) & 2147483647u)) < 1e-12f)));
let _e943 = ((_e530.member - _e904.member.x) * _e921);
let _e945 = ((_e536.member - _e904.member.x) * _e921);
let _e948 = ((_e530.member_1 - _e904.member.y) * _e930);
let _e950 = ((_e536.member_1 - _e904.member.y) * _e930);
let _e953 = ((_e530.member_2 - _e904.member.z) * _e939);
let _e955 = ((_e536.member_2 - _e904.member.z) * _e939);
let _e957 = select(_e945, _e943, (_e943 > _e945));
let _e959 = select(_e950, _e948, (_e948 > _e950));
let _e961 = select(_e959, _e957, (_e957 < _e959));
let _e963 = select(_e955, _e953, (_e953 > _e955));
let _e965 = select(_e963, _e961, (_e961 < _e963));
let _e969 = global_1.member.member_4.member;
let _e970 = bitcast<i32>(_e969);
let _e974 = global_1.member.member_4.member_1;
let _e975 = bitcast<i32>(_e974);
let _e979 = global_1.member.member_4.member_2;
let _e982 = ((_e904.member.x - 0.5f) / 4f);
let _e984 = f32((_e970 - 1i));
let _e986 = select(0f, _e982, (_e982 > 0f));
let _e988 = select(_e984, _e986, (_e986 < _e984));
let _e995 = select(0i, select(select(i32(_e988), i32(-2147483648), (_e988 < -2147483600f)), 2147483647i, (_e988 > 2147483500f)), (_e988 == _e988));
let _e999 = (_e995 - select(0i, 1i, (_e988 < f32(_e995))));
let _e1001 = ((_e904.member.y - 0.5f) / 4f);
let _e1003 = f32((_e975 - 1i));
let _e1005 = select(0f, _e1001, (_e1001 > 0f));
let _e1007 = select(_e1003, _e1005, (_e1005 < _e1003));
let _e1014 = select(0i, select(select(i32(_e1007), i32(-2147483648), (_e1007 < -2147483600f)), 2147483647i, (_e1007 > 2147483500f)), (_e1007 == _e1007));
let _e1018 = (_e1014 - select(0i, 1i, (_e1007 < f32(_e1014))));
let _e1020 = ((_e904.member.z - 0.5f) / 4f);
let _e1022 = f32((bitcast<i32>(_e979) - 1i));
let _e1024 = select(0f, _e1020, (_e1020 > 0f));
let _e1026 = select(_e1022, _e1024, (_e1024 < _e1022));
let _e1033 = select(0i, select(select(i32(_e1026), i32(-2147483648), (_e1026 < -2147483600f)), 2147483647i, (_e1026 > 2147483500f)), (_e1026 == _e1026));
let _e1037 = (_e1033 - select(0i, 1i, (_e1026 < f32(_e1033))));
let _e1041 = ((((_e1037 * _e975) + _e1018) * _e970) + _e999);
let _e1043 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1045 = select(_e1043, _e1041, (_e1041 < _e1043));
let _e1051 = global_4.member[bitcast<u32>(select(0i, _e1045, (_e1045 > 0i)))];
let _e1052 = bitcast<i32>(_e1051);
if (_e1052 > 0i) {
let _e1082 = ((((f32(((_e999 - _e1052) + 1i)) * 4f) + 0.5f) - _e904.member.x) * _e921);
let _e1084 = ((((f32((_e999 + _e1052)) * 4f) + 0.5f) - _e904.member.x) * _e921);
let _e1086 = ((((f32(((_e1018 - _e1052) + 1i)) * 4f) + 0.5f) - _e904.member.y) * _e930);
let _e1088 = ((((f32((_e1018 + _e1052)) * 4f) + 0.5f) - _e904.member.y) * _e930);
let _e1090 = ((((f32(((_e1037 - _e1052) + 1i)) * 4f) + 0.5f) - _e904.member.z) * _e939);
let _e1092 = ((((f32((_e1037 + _e1052)) * 4f) + 0.5f) - _e904.member.z) * _e939);
let _e1094 = select(_e1084, _e1082, (_e1082 > _e1084));
let _e1096 = select(_e1088, _e1086, (_e1086 > _e1088));
let _e1098 = select(_e1096, _e1094, (_e1094 < _e1096));
let _e1100 = select(_e1092, _e1090, (_e1090 > _e1092));
let _e1102 = select(_e1100, _e1098, (_e1098 < _e1100));
phi_1672_ = (select(0f, _e1102, (_e1102 > 0f)) + 1e-3f);
} else {
phi_1672_ = 0.5f;
}
let _e1107 = phi_1672_;
let _e1110 = (select(0f, _e965, (_e965 > 0f)) + 1e-3f);
let _e1112 = select(_e1110, _e1107, (_e1107 < _e1110));
let _e1114 = (_e904.member_17 <= _e1112);
let _e1115 = select(_e1112, _e904.member_17, _e1114);
let _e1125 = global_1.member.member_3;
let _e1127 = (bitcast<i32>(_e1125) - 1i);
phi_1710_ = _e1127;
phi_1713_ = 16i;
loop {
let _e1129 = phi_1710_;
let _e1131 = phi_1713_;
local_3 = _e1131;
local_21 = _e1131;
let _e1132 = (_e1129 >= 0i);
if _e1132 {
let _e1136 = global_1.member.member_2.member;
let _e1141 = global_1.member.member_2.member_1;
let _e1146 = global_1.member.member_2.member_2;
let _e1148 = ((_e904.member.x + (_e904.member_1.x * _e1115)) - 0.5f);
let _e1149 = ((_e904.member.y + (_e904.member_1.y * _e1115)) - 0.5f);
let _e1150 = ((_e904.member.z + (_e904.member_1.z * _e1115)) - 0.5f);
let _e1152 = f32((bitcast<i32>(_e1136) - 2i));
let _e1154 = select(0f, _e1148, (_e1148 > 0f));
let _e1156 = select(_e1152, _e1154, (_e1154 < _e1152));
let _e1163 = select(0i, select(select(i32(_e1156), i32(-2147483648), (_e1156 < -2147483600f)), 2147483647i, (_e1156 > 2147483500f)), (_e1156 == _e1156));
let _e1167 = (_e1163 - select(0i, 1i, (_e1156 < f32(_e1163))));
let _e1169 = f32((bitcast<i32>(_e1141) - 2i));
let _e1171 = select(0f, _e1149, (_e1149 > 0f));
let _e1173 = select(_e1169, _e1171, (_e1171 < _e1169));
let _e1180 = select(0i, select(select(i32(_e1173), i32(-2147483648), (_e1173 < -2147483600f)), 2147483647i, (_e1173 > 2147483500f)), (_e1173 == _e1173));
let _e1184 = (_e1180 - select(0i, 1i, (_e1173 < f32(_e1180))));
let _e1186 = f32((bitcast<i32>(_e1146) - 2i));
let _e1188 = select(0f, _e1150, (_e1150 > 0f));
let _e1190 = select(_e1186, _e1188, (_e1188 < _e1186));
let _e1197 = select(0i, select(select(i32(_e1190), i32(-2147483648), (_e1190 < -2147483600f)), 2147483647i, (_e1190 > 2147483500f)), (_e1190 == _e1190));
let _e1201 = (_e1197 - select(0i, 1i, (_e1190 < f32(_e1197))));
let _e1202 = (_e1129 * 4i);
let _e1203 = (_e1202 + 1i);
let _e1205 = (bitcast<i32>(_e101) - 1i);
let _e1207 = select(_e1205, _e1203, (_e1203 < _e1205));
let _e1213 = global_5.member[bitcast<u32>(select(0i, _e1207, (_e1207 > 0i)))];
let _e1214 = (_e1202 + 2i);
let _e1216 = select(_e1205, _e1214, (_e1214 < _e1205));
let _e1222 = global_5.member[bitcast<u32>(select(0i, _e1216, (_e1216 > 0i)))];
let _e1223 = (_e1202 + 3i);
let _e1225 = select(_e1205, _e1223, (_e1223 < _e1205));
let _e1231 = global_5.member[bitcast<u32>(select(0i, _e1225, (_e1225 > 0i)))];
let _e1234 = (_e1167 - bitcast<i32>((_e1213 & 65535u)));
let _e1239 = bitcast<i32>((_e1213 >> bitcast<u32>(16i)));
let _e1244 = (_e1184 - bitcast<i32>((_e1222 & 65535u)));
let _e1249 = bitcast<i32>((_e1222 >> bitcast<u32>(16i)));
let _e1254 = (_e1201 - bitcast<i32>((_e1231 & 65535u)));
if ((((_e1234 >= 0i) && ((_e1234 + 1i) < _e1239)) && ((_e1244 >= 0i) && ((_e1244 + 1i) < _e1249))) && ((_e1254 >= 0i) && ((_e1254 + 1i) < bitcast<i32>((_e1231 >> bitcast<u32>(16i)))))) {
let _e1264 = (_e1249 * _e1239);
let _e1266 = select(_e1205, _e1202, (_e1202 < _e1205));
let _e1272 = global_5.member[bitcast<u32>(select(0i, _e1266, (_e1266 > 0i)))];
let _e1278 = (((bitcast<i32>(_e1272) + (_e1254 * _e1264)) + (_e1244 * _e1239)) + _e1234);
let _e1280 = (_e1148 - f32(_e1167));
let _e1282 = (_e1149 - f32(_e1184));
let _e1285 = (2i * _e1278);
let _e1287 = (_e1285 >> bitcast<u32>(2i));
let _e1290 = bitcast<u32>(((_e1285 & 3i) * 8i));
let _e1292 = select(_e1205, _e1287, (_e1287 < _e1205));
let _e1298 = global_5.member[bitcast<u32>(select(0i, _e1292, (_e1292 > 0i)))];
let _e1302 = (_e1287 + 1i);
let _e1304 = select(_e1205, _e1302, (_e1302 < _e1205));
let _e1310 = global_5.member[bitcast<u32>(select(0i, _e1304, (_e1304 > 0i)))];
let _e1317 = ((_e1298 >> bitcast<u32>((_e1290 & 31u))) | ((_e1310 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1290) & 31u))));
let _e1320 = f32(bitcast<i32>((_e1317 & 65535u)));
let _e1327 = (_e1320 + ((f32(bitcast<i32>((_e1317 >> bitcast<u32>(16i)))) - _e1320) * _e1280));
let _e1329 = (2i * (_e1278 + _e1239));
let _e1331 = (_e1329 >> bitcast<u32>(2i));
let _e1334 = bitcast<u32>(((_e1329 & 3i) * 8i));
let _e1336 = select(_e1205, _e1331, (_e1331 < _e1205));
let _e1342 = global_5.member[bitcast<u32>(select(0i, _e1336, (_e1336 > 0i)))];
let _e1346 = (_e1331 + 1i);
let _e1348 = select(_e1205, _e1346, (_e1346 < _e1205));
let _e1354 = global_5.member[bitcast<u32>(select(0i, _e1348, (_e1348 > 0i)))];
let _e1361 = ((_e1342 >> bitcast<u32>((_e1334 & 31u))) | ((_e1354 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1334) & 31u))));
let _e1364 = f32(bitcast<i32>((_e1361 & 65535u)));
let _e1372 = (_e1278 + _e1264);
let _e1373 = (2i * _e1372);
let _e1375 = (_e1373 >> bitcast<u32>(2i));
let _e1378 = bitcast<u32>(((_e1373 & 3i) * 8i));
let _e1380 = select(_e1205, _e1375, (_e1375 < _e1205));
let _e1386 = global_5.member[bitcast<u32>(select(0i, _e1380, (_e1380 > 0i)))];
let _e1390 = (_e1375 + 1i);
let _e1392 = select(_e1205, _e1390, (_e1390 < _e1205));
let _e1398 = global_5.member[bitcast<u32>(select(0i, _e1392, (_e1392 > 0i)))];
let _e1405 = ((_e1386 >> bitcast<u32>((_e1378 & 31u))) | ((_e1398 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1378) & 31u))));
let _e1408 = f32(bitcast<i32>((_e1405 & 65535u)));
let _e1415 = (_e1408 + ((f32(bitcast<i32>((_e1405 >> bitcast<u32>(16i)))) - _e1408) * _e1280));
let _e1417 = (2i * (_e1372 + _e1239));
let _e1419 = (_e1417 >> bitcast<u32>(2i));
let _e1422 = bitcast<u32>(((_e1417 & 3i) * 8i));
let _e1424 = select(_e1205, _e1419, (_e1419 < _e1205));
let _e1430 = global_5.member[bitcast<u32>(select(0i, _e1424, (_e1424 > 0i)))];
let _e1434 = (_e1419 + 1i);
let _e1436 = select(_e1205, _e1434, (_e1434 < _e1205));
let _e1442 = global_5.member[bitcast<u32>(select(0i, _e1436, (_e1436 > 0i)))];
let _e1449 = ((_e1430 >> bitcast<u32>((_e1422 & 31u))) | ((_e1442 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1422) & 31u))));
let _e1452 = f32(bitcast<i32>((_e1449 & 65535u)));
let _e1462 = (_e1327 + (((_e1364 + ((f32(bitcast<i32>((_e1361 >> bitcast<u32>(16i)))) - _e1364) * _e1280)) - _e1327) * _e1282));
phi_2149_ = (_e1462 + (((_e1415 + (((_e1452 + ((f32(bitcast<i32>((_e1449 >> bitcast<u32>(16i)))) - _e1452) * _e1280)) - _e1415) * _e1282)) - _e1462) * (_e1150 - f32(_e1201))));
} else {
phi_2149_ = 0f;
}
let _e1470 = phi_2149_;
phi_1711_ = (_e1129 - 1i);
phi_1714_ = select(_e1131, _e1129, (_e1470 > 32767.5f));
} else {
phi_1711_ = i32();
phi_1714_ = i32();
}
let _e1475 = phi_1711_;
let _e1477 = phi_1714_;
continue;
continuing {
phi_1710_ = _e1475;
phi_1713_ = _e1477;
break if !(_e1132);
}
}
let _e1480 = local_3;
let _e1481 = (_e1480 == _e904.member_7);
if _e1481 {
phi_7299_ = _e904;
phi_7300_ = _e1481;
} else {
phi_2161_ = 0i;
phi_2164_ = 0f;
phi_2166_ = _e1115;
loop {
let _e1483 = phi_2161_;
let _e1485 = phi_2164_;
let _e1487 = phi_2166_;
local_5 = _e1487;
local_6 = _e1487;
local_7 = _e1487;
local_10 = _e1487;
local_12 = _e1487;
local_13 = _e1487;
local_14 = _e1487;
local_15 = _e1487;
local_16 = _e1487;
let _e1488 = (_e1483 < 12i);
if _e1488 {
let _e1490 = (0.5f * (_e1485 + _e1487));
phi_2195_ = _e1127;
phi_2198_ = 16i;
loop {
let _e1498 = phi_2195_;
let _e1500 = phi_2198_;
local_4 = _e1500;
let _e1501 = (_e1498 >= 0i);
if _e1501 {
let _e1505 = global_1.member.member_2.member;
let _e1510 = global_1.member.member_2.member_1;
let _e1515 = global_1.member.member_2.member_2;
let _e1517 = ((_e904.member.x + (_e904.member_1.x * _e1490)) - 0.5f);
let _e1518 = ((_e904.member.y + (_e904.member_1.y * _e1490)) - 0.5f);
let _e1519 = ((_e904.member.z + (_e904.member_1.z * _e1490)) - 0.5f);
let _e1521 = f32((bitcast<i32>(_e1505) - 2i));
let _e1523 = select(0f, _e1517, (_e1517 > 0f));
let _e1525 = select(_e1521, _e1523, (_e1523 < _e1521));
let _e1532 = select(0i, select(select(i32(_e1525), i32(-2147483648), (_e1525 < -2147483600f)), 2147483647i, (_e1525 > 2147483500f)), (_e1525 == _e1525));
let _e1536 = (_e1532 - select(0i, 1i, (_e1525 < f32(_e1532))));
let _e1538 = f32((bitcast<i32>(_e1510) - 2i));
let _e1540 = select(0f, _e1518, (_e1518 > 0f));
let _e1542 = select(_e1538, _e1540, (_e1540 < _e1538));
let _e1549 = select(0i, select(select(i32(_e1542), i32(-2147483648), (_e1542 < -2147483600f)), 2147483647i, (_e1542 > 2147483500f)), (_e1542 == _e1542));
let _e1553 = (_e1549 - select(0i, 1i, (_e1542 < f32(_e1549))));
let _e1555 = f32((bitcast<i32>(_e1515) - 2i));
let _e1557 = select(0f, _e1519, (_e1519 > 0f));
let _e1559 = select(_e1555, _e1557, (_e1557 < _e1555));
let _e1566 = select(0i, select(select(i32(_e1559), i32(-2147483648), (_e1559 < -2147483600f)), 2147483647i, (_e1559 > 2147483500f)), (_e1559 == _e1559));
let _e1570 = (_e1566 - select(0i, 1i, (_e1559 < f32(_e1566))));
let _e1571 = (_e1498 * 4i);
let _e1572 = (_e1571 + 1i);
let _e1574 = (bitcast<i32>(_e101) - 1i);
let _e1576 = select(_e1574, _e1572, (_e1572 < _e1574));
let _e1582 = global_5.member[bitcast<u32>(select(0i, _e1576, (_e1576 > 0i)))];
let _e1583 = (_e1571 + 2i);
let _e1585 = select(_e1574, _e1583, (_e1583 < _e1574));
let _e1591 = global_5.member[bitcast<u32>(select(0i, _e1585, (_e1585 > 0i)))];
let _e1592 = (_e1571 + 3i);
let _e1594 = select(_e1574, _e1592, (_e1592 < _e1574));
let _e1600 = global_5.member[bitcast<u32>(select(0i, _e1594, (_e1594 > 0i)))];
let _e1603 = (_e1536 - bitcast<i32>((_e1582 & 65535u)));
let _e1608 = bitcast<i32>((_e1582 >> bitcast<u32>(16i)));
let _e1613 = (_e1553 - bitcast<i32>((_e1591 & 65535u)));
let _e1618 = bitcast<i32>((_e1591 >> bitcast<u32>(16i)));
let _e1623 = (_e1570 - bitcast<i32>((_e1600 & 65535u)));
if ((((_e1603 >= 0i) && ((_e1603 + 1i) < _e1608)) && ((_e1613 >= 0i) && ((_e1613 + 1i) < _e1618))) && ((_e1623 >= 0i) && ((_e1623 + 1i) < bitcast<i32>((_e1600 >> bitcast<u32>(16i)))))) {
let _e1633 = (_e1618 * _e1608);
let _e1635 = select(_e1574, _e1571, (_e1571 < _e1574));
let _e1641 = global_5.member[bitcast<u32>(select(0i, _e1635, (_e1635 > 0i)))];
let _e1647 = (((bitcast<i32>(_e1641) + (_e1623 * _e1633)) + (_e1613 * _e1608)) + _e1603);
let _e1649 = (_e1517 - f32(_e1536));
let _e1651 = (_e1518 - f32(_e1553));
let _e1654 = (2i * _e1647);
let _e1656 = (_e1654 >> bitcast<u32>(2i));
let _e1659 = bitcast<u32>(((_e1654 & 3i) * 8i));
let _e1661 = select(_e1574, _e1656, (_e1656 < _e1574));
let _e1667 = global_5.member[bitcast<u32>(select(0i, _e1661, (_e1661 > 0i)))];
let _e1671 = (_e1656 + 1i);
let _e1673 = select(_e1574, _e1671, (_e1671 < _e1574));
let _e1679 = global_5.member[bitcast<u32>(select(0i, _e1673, (_e1673 > 0i)))];
let _e1686 = ((_e1667 >> bitcast<u32>((_e1659 & 31u))) | ((_e1679 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1659) & 31u))));
let _e1689 = f32(bitcast<i32>((_e1686 & 65535u)));
let _e1696 = (_e1689 + ((f32(bitcast<i32>((_e1686 >> bitcast<u32>(16i)))) - _e1689) * _e1649));
let _e1698 = (2i * (_e1647 + _e1608));
let _e1700 = (_e1698 >> bitcast<u32>(2i));
let _e1703 = bitcast<u32>(((_e1698 & 3i) * 8i));
let _e1705 = select(_e1574, _e1700, (_e1700 < _e1574));
let _e1711 = global_5.member[bitcast<u32>(select(0i, _e1705, (_e1705 > 0i)))];
let _e1715 = (_e1700 + 1i);
let _e1717 = select(_e1574, _e1715, (_e1715 < _e1574));
let _e1723 = global_5.member[bitcast<u32>(select(0i, _e1717, (_e1717 > 0i)))];
let _e1730 = ((_e1711 >> bitcast<u32>((_e1703 & 31u))) | ((_e1723 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1703) & 31u))));
let _e1733 = f32(bitcast<i32>((_e1730 & 65535u)));
let _e1741 = (_e1647 + _e1633);
let _e1742 = (2i * _e1741);
let _e1744 = (_e1742 >> bitcast<u32>(2i));
let _e1747 = bitcast<u32>(((_e1742 & 3i) * 8i));
let _e1749 = select(_e1574, _e1744, (_e1744 < _e1574));
let _e1755 = global_5.member[bitcast<u32>(select(0i, _e1749, (_e1749 > 0i)))];
let _e1759 = (_e1744 + 1i);
let _e1761 = select(_e1574, _e1759, (_e1759 < _e1574));
let _e1767 = global_5.member[bitcast<u32>(select(0i, _e1761, (_e1761 > 0i)))];
let _e1774 = ((_e1755 >> bitcast<u32>((_e1747 & 31u))) | ((_e1767 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1747) & 31u))));
let _e1777 = f32(bitcast<i32>((_e1774 & 65535u)));
let _e1784 = (_e1777 + ((f32(bitcast<i32>((_e1774 >> bitcast<u32>(16i)))) - _e1777) * _e1649));
let _e1786 = (2i * (_e1741 + _e1608));
let _e1788 = (_e1786 >> bitcast<u32>(2i));
let _e1791 = bitcast<u32>(((_e1786 & 3i) * 8i));
let _e1793 = select(_e1574, _e1788, (_e1788 < _e1574));
let _e1799 = global_5.member[bitcast<u32>(select(0i, _e1793, (_e1793 > 0i)))];
let _e1803 = (_e1788 + 1i);
let _e1805 = select(_e1574, _e1803, (_e1803 < _e1574));
let _e1811 = global_5.member[bitcast<u32>(select(0i, _e1805, (_e1805 > 0i)))];
let _e1818 = ((_e1799 >> bitcast<u32>((_e1791 & 31u))) | ((_e1811 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1791) & 31u))));
let _e1821 = f32(bitcast<i32>((_e1818 & 65535u)));
let _e1831 = (_e1696 + (((_e1733 + ((f32(bitcast<i32>((_e1730 >> bitcast<u32>(16i)))) - _e1733) * _e1649)) - _e1696) * _e1651));
phi_2634_ = (_e1831 + (((_e1784 + (((_e1821 + ((f32(bitcast<i32>((_e1818 >> bitcast<u32>(16i)))) - _e1821) * _e1649)) - _e1784) * _e1651)) - _e1831) * (_e1519 - f32(_e1570))));
} else {
phi_2634_ = 0f;
}
let _e1839 = phi_2634_;
phi_2196_ = (_e1498 - 1i);
phi_2199_ = select(_e1500, _e1498, (_e1839 > 32767.5f));
} else {
phi_2196_ = i32();
phi_2199_ = i32();
}
let _e1844 = phi_2196_;
let _e1846 = phi_2199_;
continue;
continuing {
phi_2195_ = _e1844;
phi_2198_ = _e1846;
break if !(_e1501);
}
}
let _e1849 = local_4;
let _e1850 = (_e1849 == _e904.member_7);
phi_2162_ = (_e1483 + 1i);
phi_2165_ = select(_e1485, _e1490, _e1850);
phi_2167_ = select(_e1490, _e1487, _e1850);
} else {
phi_2162_ = i32();
phi_2165_ = f32();
phi_2167_ = f32();
}
let _e1855 = phi_2162_;
let _e1857 = phi_2165_;
let _e1859 = phi_2167_;
continue;
continuing {
phi_2161_ = _e1855;
phi_2164_ = _e1857;
phi_2166_ = _e1859;
break if !(_e1488);
}
}
let _e1862 = local_5;
let _e1863 = (_e904.member_1.x * _e1862);
let _e1865 = local_6;
let _e1866 = (_e904.member_1.y * _e1865);
let _e1868 = local_7;
let _e1869 = (_e904.member_1.z * _e1868);
phi_2669_ = _e1127;
phi_2672_ = 16i;
loop {
let _e1876 = phi_2669_;
let _e1878 = phi_2672_;
local_8 = _e1878;
local_9 = _e1878;
local_11 = _e1878;
local_17 = _e1878;
local_18 = _e1878;
local_19 = _e1878;
local_20 = _e1878;
let _e1879 = (_e1876 >= 0i);
if _e1879 {
let _e1883 = global_1.member.member_2.member;
let _e1888 = global_1.member.member_2.member_1;
let _e1893 = global_1.member.member_2.member_2;
let _e1895 = ((_e904.member.x + _e1863) - 0.5f);
let _e1896 = ((_e904.member.y + _e1866) - 0.5f);
let _e1897 = ((_e904.member.z + _e1869) - 0.5f);
let _e1899 = f32((bitcast<i32>(_e1883) - 2i));
let _e1901 = select(0f, _e1895, (_e1895 > 0f));
let _e1903 = select(_e1899, _e1901, (_e1901 < _e1899));
let _e1910 = select(0i, select(select(i32(_e1903), i32(-2147483648), (_e1903 < -2147483600f)), 2147483647i, (_e1903 > 2147483500f)), (_e1903 == _e1903));
let _e1914 = (_e1910 - select(0i, 1i, (_e1903 < f32(_e1910))));
let _e1916 = f32((bitcast<i32>(_e1888) - 2i));
let _e1918 = select(0f, _e1896, (_e1896 > 0f));
let _e1920 = select(_e1916, _e1918, (_e1918 < _e1916));
let _e1927 = select(0i, select(select(i32(_e1920), i32(-2147483648), (_e1920 < -2147483600f)), 2147483647i, (_e1920 > 2147483500f)), (_e1920 == _e1920));
let _e1931 = (_e1927 - select(0i, 1i, (_e1920 < f32(_e1927))));
let _e1933 = f32((bitcast<i32>(_e1893) - 2i));
let _e1935 = select(0f, _e1897, (_e1897 > 0f));
let _e1937 = select(_e1933, _e1935, (_e1935 < _e1933));
let _e1944 = select(0i, select(select(i32(_e1937), i32(-2147483648), (_e1937 < -2147483600f)), 2147483647i, (_e1937 > 2147483500f)), (_e1937 == _e1937));
let _e1948 = (_e1944 - select(0i, 1i, (_e1937 < f32(_e1944))));
let _e1949 = (_e1876 * 4i);
let _e1950 = (_e1949 + 1i);
let _e1952 = (bitcast<i32>(_e101) - 1i);
let _e1954 = select(_e1952, _e1950, (_e1950 < _e1952));
let _e1960 = global_5.member[bitcast<u32>(select(0i, _e1954, (_e1954 > 0i)))];
let _e1961 = (_e1949 + 2i);
let _e1963 = select(_e1952, _e1961, (_e1961 < _e1952));
let _e1969 = global_5.member[bitcast<u32>(select(0i, _e1963, (_e1963 > 0i)))];
let _e1970 = (_e1949 + 3i);
let _e1972 = select(_e1952, _e1970, (_e1970 < _e1952));
let _e1978 = global_5.member[bitcast<u32>(select(0i, _e1972, (_e1972 > 0i)))];
let _e1981 = (_e1914 - bitcast<i32>((_e1960 & 65535u)));
let _e1986 = bitcast<i32>((_e1960 >> bitcast<u32>(16i)));
let _e1991 = (_e1931 - bitcast<i32>((_e1969 & 65535u)));
let _e1996 = bitcast<i32>((_e1969 >> bitcast<u32>(16i)));
let _e2001 = (_e1948 - bitcast<i32>((_e1978 & 65535u)));
if ((((_e1981 >= 0i) && ((_e1981 + 1i) < _e1986)) && ((_e1991 >= 0i) && ((_e1991 + 1i) < _e1996))) && ((_e2001 >= 0i) && ((_e2001 + 1i) < bitcast<i32>((_e1978 >> bitcast<u32>(16i)))))) {
let _e2011 = (_e1996 * _e1986);
let _e2013 = select(_e1952, _e1949, (_e1949 < _e1952));
let _e2019 = global_5.member[bitcast<u32>(select(0i, _e2013, (_e2013 > 0i)))];
let _e2025 = (((bitcast<i32>(_e2019) + (_e2001 * _e2011)) + (_e1991 * _e1986)) + _e1981);
let _e2027 = (_e1895 - f32(_e1914));
let _e2029 = (_e1896 - f32(_e1931));
let _e2032 = (2i * _e2025);
let _e2034 = (_e2032 >> bitcast<u32>(2i));
let _e2037 = bitcast<u32>(((_e2032 & 3i) * 8i));
let _e2039 = select(_e1952, _e2034, (_e2034 < _e1952));
let _e2045 = global_5.member[bitcast<u32>(select(0i, _e2039, (_e2039 > 0i)))];
let _e2049 = (_e2034 + 1i);
let _e2051 = select(_e1952, _e2049, (_e2049 < _e1952));
let _e2057 = global_5.member[bitcast<u32>(select(0i, _e2051, (_e2051 > 0i)))];
let _e2064 = ((_e2045 >> bitcast<u32>((_e2037 & 31u))) | ((_e2057 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2037) & 31u))));
let _e2067 = f32(bitcast<i32>((_e2064 & 65535u)));
let _e2074 = (_e2067 + ((f32(bitcast<i32>((_e2064 >> bitcast<u32>(16i)))) - _e2067) * _e2027));
let _e2076 = (2i * (_e2025 + _e1986));
let _e2078 = (_e2076 >> bitcast<u32>(2i));
let _e2081 = bitcast<u32>(((_e2076 & 3i) * 8i));
let _e2083 = select(_e1952, _e2078, (_e2078 < _e1952));
let _e2089 = global_5.member[bitcast<u32>(select(0i, _e2083, (_e2083 > 0i)))];
let _e2093 = (_e2078 + 1i);
let _e2095 = select(_e1952, _e2093, (_e2093 < _e1952));
let _e2101 = global_5.member[bitcast<u32>(select(0i, _e2095, (_e2095 > 0i)))];
let _e2108 = ((_e2089 >> bitcast<u32>((_e2081 & 31u))) | ((_e2101 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2081) & 31u))));
let _e2111 = f32(bitcast<i32>((_e2108 & 65535u)));
let _e2119 = (_e2025 + _e2011);
let _e2120 = (2i * _e2119);
let _e2122 = (_e2120 >> bitcast<u32>(2i));
let _e2125 = bitcast<u32>(((_e2120 & 3i) * 8i));
let _e2127 = select(_e1952, _e2122, (_e2122 < _e1952));
let _e2133 = global_5.member[bitcast<u32>(select(0i, _e2127, (_e2127 > 0i)))];
let _e2137 = (_e2122 + 1i);
let _e2139 = select(_e1952, _e2137, (_e2137 < _e1952));
let _e2145 = global_5.member[bitcast<u32>(select(0i, _e2139, (_e2139 > 0i)))];
let _e2152 = ((_e2133 >> bitcast<u32>((_e2125 & 31u))) | ((_e2145 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2125) & 31u))));
let _e2155 = f32(bitcast<i32>((_e2152 & 65535u)));
let _e2162 = (_e2155 + ((f32(bitcast<i32>((_e2152 >> bitcast<u32>(16i)))) - _e2155) * _e2027));
let _e2164 = (2i * (_e2119 + _e1986));
let _e2166 = (_e2164 >> bitcast<u32>(2i));
let _e2169 = bitcast<u32>(((_e2164 & 3i) * 8i));
let _e2171 = select(_e1952, _e2166, (_e2166 < _e1952));
let _e2177 = global_5.member[bitcast<u32>(select(0i, _e2171, (_e2171 > 0i)))];
let _e2181 = (_e2166 + 1i);
let _e2183 = select(_e1952, _e2181, (_e2181 < _e1952));
let _e2189 = global_5.member[bitcast<u32>(select(0i, _e2183, (_e2183 > 0i)))];
let _e2196 = ((_e2177 >> bitcast<u32>((_e2169 & 31u))) | ((_e2189 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2169) & 31u))));
let _e2199 = f32(bitcast<i32>((_e2196 & 65535u)));
let _e2209 = (_e2074 + (((_e2111 + ((f32(bitcast<i32>((_e2108 >> bitcast<u32>(16i)))) - _e2111) * _e2027)) - _e2074) * _e2029));
phi_3108_ = (_e2209 + (((_e2162 + (((_e2199 + ((f32(bitcast<i32>((_e2196 >> bitcast<u32>(16i)))) - _e2199) * _e2027)) - _e2162) * _e2029)) - _e2209) * (_e1897 - f32(_e1948))));
} else {
phi_3108_ = 0f;
}
let _e2217 = phi_3108_;
phi_2670_ = (_e1876 - 1i);
phi_2673_ = select(_e1878, _e1876, (_e2217 > 32767.5f));
} else {
phi_2670_ = i32();
phi_2673_ = i32();
}
let _e2222 = phi_2670_;
let _e2224 = phi_2673_;
continue;
continuing {
phi_2669_ = _e2222;
phi_2672_ = _e2224;
break if !(_e1879);
}
}
let _e2227 = local_8;
let _e2230 = local_9;
local = select(_e904.member_7, _e2230, (_e2227 < _e904.member_7));
local_1 = (_e904.member + vec3<f32>(_e1863, _e1866, _e1869));
let _e2235 = local;
let _e2236 = local_1[0u];
let _e2238 = local_1[1u];
let _e2240 = local_1[2u];
let _e2244 = global_1.member.member_2.member;
let _e2248 = global_1.member.member_2.member_1;
let _e2252 = global_1.member.member_2.member_2;
let _e2254 = ((_e2236 + -1f) - 0.5f);
let _e2255 = ((_e2238 + 0f) - 0.5f);
let _e2256 = ((_e2240 + 0f) - 0.5f);
let _e2258 = f32((bitcast<i32>(_e2244) - 2i));
let _e2260 = select(0f, _e2254, (_e2254 > 0f));
let _e2262 = select(_e2258, _e2260, (_e2260 < _e2258));
let _e2269 = select(0i, select(select(i32(_e2262), i32(-2147483648), (_e2262 < -2147483600f)), 2147483647i, (_e2262 > 2147483500f)), (_e2262 == _e2262));
let _e2273 = (_e2269 - select(0i, 1i, (_e2262 < f32(_e2269))));
let _e2275 = f32((bitcast<i32>(_e2248) - 2i));
let _e2277 = select(0f, _e2255, (_e2255 > 0f));
let _e2279 = select(_e2275, _e2277, (_e2277 < _e2275));
let _e2286 = select(0i, select(select(i32(_e2279), i32(-2147483648), (_e2279 < -2147483600f)), 2147483647i, (_e2279 > 2147483500f)), (_e2279 == _e2279));
let _e2290 = (_e2286 - select(0i, 1i, (_e2279 < f32(_e2286))));
let _e2292 = f32((bitcast<i32>(_e2252) - 2i));
let _e2294 = select(0f, _e2256, (_e2256 > 0f));
let _e2296 = select(_e2292, _e2294, (_e2294 < _e2292));
let _e2303 = select(0i, select(select(i32(_e2296), i32(-2147483648), (_e2296 < -2147483600f)), 2147483647i, (_e2296 > 2147483500f)), (_e2296 == _e2296));
let _e2307 = (_e2303 - select(0i, 1i, (_e2296 < f32(_e2303))));
let _e2308 = (_e2235 * 4i);
let _e2309 = (_e2308 + 1i);
let _e2311 = (bitcast<i32>(_e101) - 1i);
let _e2313 = select(_e2311, _e2309, (_e2309 < _e2311));
let _e2318 = global_5.member[bitcast<u32>(select(0i, _e2313, (_e2313 > 0i)))];
let _e2319 = (_e2308 + 2i);
let _e2321 = select(_e2311, _e2319, (_e2319 < _e2311));
let _e2326 = global_5.member[bitcast<u32>(select(0i, _e2321, (_e2321 > 0i)))];
let _e2327 = (_e2308 + 3i);
let _e2329 = select(_e2311, _e2327, (_e2327 < _e2311));
let _e2334 = global_5.member[bitcast<u32>(select(0i, _e2329, (_e2329 > 0i)))];
let _e2337 = (_e2273 - bitcast<i32>((_e2318 & 65535u)));
let _e2342 = bitcast<i32>((_e2318 >> bitcast<u32>(16i)));
let _e2347 = (_e2290 - bitcast<i32>((_e2326 & 65535u)));
let _e2352 = bitcast<i32>((_e2326 >> bitcast<u32>(16i)));
let _e2357 = (_e2307 - bitcast<i32>((_e2334 & 65535u)));
if ((((_e2337 >= 0i) && ((_e2337 + 1i) < _e2342)) && ((_e2347 >= 0i) && ((_e2347 + 1i) < _e2352))) && ((_e2357 >= 0i) && ((_e2357 + 1i) < bitcast<i32>((_e2334 >> bitcast<u32>(16i)))))) {
let _e2367 = (_e2352 * _e2342);
let _e2369 = select(_e2311, _e2308, (_e2308 < _e2311));
let _e2374 = global_5.member[bitcast<u32>(select(0i, _e2369, (_e2369 > 0i)))];
let _e2380 = (((bitcast<i32>(_e2374) + (_e2357 * _e2367)) + (_e2347 * _e2342)) + _e2337);
let _e2382 = (_e2254 - f32(_e2273));
let _e2384 = (_e2255 - f32(_e2290));
let _e2387 = (2i * _e2380);
let _e2389 = (_e2387 >> bitcast<u32>(2i));
let _e2392 = bitcast<u32>(((_e2387 & 3i) * 8i));
let _e2394 = select(_e2311, _e2389, (_e2389 < _e2311));
let _e2399 = global_5.member[bitcast<u32>(select(0i, _e2394, (_e2394 > 0i)))];
let _e2403 = (_e2389 + 1i);
let _e2405 = select(_e2311, _e2403, (_e2403 < _e2311));
let _e2410 = global_5.member[bitcast<u32>(select(0i, _e2405, (_e2405 > 0i)))];
let _e2417 = ((_e2399 >> bitcast<u32>((_e2392 & 31u))) | ((_e2410 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2392) & 31u))));
let _e2420 = f32(bitcast<i32>((_e2417 & 65535u)));
let _e2427 = (_e2420 + ((f32(bitcast<i32>((_e2417 >> bitcast<u32>(16i)))) - _e2420) * _e2382));
let _e2429 = (2i * (_e2380 + _e2342));
let _e2431 = (_e2429 >> bitcast<u32>(2i));
let _e2434 = bitcast<u32>(((_e2429 & 3i) * 8i));
let _e2436 = select(_e2311, _e2431, (_e2431 < _e2311));
let _e2441 = global_5.member[bitcast<u32>(select(0i, _e2436, (_e2436 > 0i)))];
let _e2445 = (_e2431 + 1i);
let _e2447 = select(_e2311, _e2445, (_e2445 < _e2311));
let _e2452 = global_5.member[bitcast<u32>(select(0i, _e2447, (_e2447 > 0i)))];
let _e2459 = ((_e2441 >> bitcast<u32>((_e2434 & 31u))) | ((_e2452 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2434) & 31u))));
let _e2462 = f32(bitcast<i32>((_e2459 & 65535u)));
let _e2470 = (_e2380 + _e2367);
let _e2471 = (2i * _e2470);
let _e2473 = (_e2471 >> bitcast<u32>(2i));
let _e2476 = bitcast<u32>(((_e2471 & 3i) * 8i));
let _e2478 = select(_e2311, _e2473, (_e2473 < _e2311));
let _e2483 = global_5.member[bitcast<u32>(select(0i, _e2478, (_e2478 > 0i)))];
let _e2487 = (_e2473 + 1i);
let _e2489 = select(_e2311, _e2487, (_e2487 < _e2311));
let _e2494 = global_5.member[bitcast<u32>(select(0i, _e2489, (_e2489 > 0i)))];
let _e2501 = ((_e2483 >> bitcast<u32>((_e2476 & 31u))) | ((_e2494 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2476) & 31u))));
let _e2504 = f32(bitcast<i32>((_e2501 & 65535u)));
let _e2511 = (_e2504 + ((f32(bitcast<i32>((_e2501 >> bitcast<u32>(16i)))) - _e2504) * _e2382));
let _e2513 = (2i * (_e2470 + _e2342));
let _e2515 = (_e2513 >> bitcast<u32>(2i));
let _e2518 = bitcast<u32>(((_e2513 & 3i) * 8i));
let _e2520 = select(_e2311, _e2515, (_e2515 < _e2311));
let _e2525 = global_5.member[bitcast<u32>(select(0i, _e2520, (_e2520 > 0i)))];
let _e2529 = (_e2515 + 1i);
let _e2531 = select(_e2311, _e2529, (_e2529 < _e2311));
let _e2536 = global_5.member[bitcast<u32>(select(0i, _e2531, (_e2531 > 0i)))];
let _e2543 = ((_e2525 >> bitcast<u32>((_e2518 & 31u))) | ((_e2536 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2518) & 31u))));
let _e2546 = f32(bitcast<i32>((_e2543 & 65535u)));
let _e2556 = (_e2427 + (((_e2462 + ((f32(bitcast<i32>((_e2459 >> bitcast<u32>(16i)))) - _e2462) * _e2382)) - _e2427) * _e2384));
phi_3568_ = (_e2556 + (((_e2511 + (((_e2546 + ((f32(bitcast<i32>((_e2543 >> bitcast<u32>(16i)))) - _e2546) * _e2382)) - _e2511) * _e2384)) - _e2556) * (_e2256 - f32(_e2307))));
} else {
phi_3568_ = 0f;
}
let _e2564 = phi_3568_;
let _e2565 = local;
let _e2566 = local_1[0u];
let _e2568 = local_1[1u];
let _e2570 = local_1[2u];
let _e2572 = ((_e2566 + 1f) - 0.5f);
let _e2573 = ((_e2568 + 0f) - 0.5f);
let _e2574 = ((_e2570 + 0f) - 0.5f);
let _e2576 = select(0f, _e2572, (_e2572 > 0f));
let _e2578 = select(_e2258, _e2576, (_e2576 < _e2258));
let _e2585 = select(0i, select(select(i32(_e2578), i32(-2147483648), (_e2578 < -2147483600f)), 2147483647i, (_e2578 > 2147483500f)), (_e2578 == _e2578));
let _e2589 = (_e2585 - select(0i, 1i, (_e2578 < f32(_e2585))));
let _e2591 = select(0f, _e2573, (_e2573 > 0f));
let _e2593 = select(_e2275, _e2591, (_e2591 < _e2275));
let _e2600 = select(0i, select(select(i32(_e2593), i32(-2147483648), (_e2593 < -2147483600f)), 2147483647i, (_e2593 > 2147483500f)), (_e2593 == _e2593));
let _e2604 = (_e2600 - select(0i, 1i, (_e2593 < f32(_e2600))));
let _e2606 = select(0f, _e2574, (_e2574 > 0f));
let _e2608 = select(_e2292, _e2606, (_e2606 < _e2292));
let _e2615 = select(0i, select(select(i32(_e2608), i32(-2147483648), (_e2608 < -2147483600f)), 2147483647i, (_e2608 > 2147483500f)), (_e2608 == _e2608));
let _e2619 = (_e2615 - select(0i, 1i, (_e2608 < f32(_e2615))));
let _e2620 = (_e2565 * 4i);
let _e2621 = (_e2620 + 1i);
let _e2623 = select(_e2311, _e2621, (_e2621 < _e2311));
let _e2628 = global_5.member[bitcast<u32>(select(0i, _e2623, (_e2623 > 0i)))];
let _e2629 = (_e2620 + 2i);
let _e2631 = select(_e2311, _e2629, (_e2629 < _e2311));
let _e2636 = global_5.member[bitcast<u32>(select(0i, _e2631, (_e2631 > 0i)))];
let _e2637 = (_e2620 + 3i);
let _e2639 = select(_e2311, _e2637, (_e2637 < _e2311));
let _e2644 = global_5.member[bitcast<u32>(select(0i, _e2639, (_e2639 > 0i)))];
let _e2647 = (_e2589 - bitcast<i32>((_e2628 & 65535u)));
let _e2652 = bitcast<i32>((_e2628 >> bitcast<u32>(16i)));
let _e2657 = (_e2604 - bitcast<i32>((_e2636 & 65535u)));
let _e2662 = bitcast<i32>((_e2636 >> bitcast<u32>(16i)));
let _e2667 = (_e2619 - bitcast<i32>((_e2644 & 65535u)));
if ((((_e2647 >= 0i) && ((_e2647 + 1i) < _e2652)) && ((_e2657 >= 0i) && ((_e2657 + 1i) < _e2662))) && ((_e2667 >= 0i) && ((_e2667 + 1i) < bitcast<i32>((_e2644 >> bitcast<u32>(16i)))))) {
let _e2677 = (_e2662 * _e2652);
let _e2679 = select(_e2311, _e2620, (_e2620 < _e2311));
let _e2684 = global_5.member[bitcast<u32>(select(0i, _e2679, (_e2679 > 0i)))];
let _e2690 = (((bitcast<i32>(_e2684) + (_e2667 * _e2677)) + (_e2657 * _e2652)) + _e2647);
let _e2692 = (_e2572 - f32(_e2589));
let _e2694 = (_e2573 - f32(_e2604));
let _e2697 = (2i * _e2690);
let _e2699 = (_e2697 >> bitcast<u32>(2i));
let _e2702 = bitcast<u32>(((_e2697 & 3i) * 8i));
let _e2704 = select(_e2311, _e2699, (_e2699 < _e2311));
let _e2709 = global_5.member[bitcast<u32>(select(0i, _e2704, (_e2704 > 0i)))];
let _e2713 = (_e2699 + 1i);
let _e2715 = select(_e2311, _e2713, (_e2713 < _e2311));
let _e2720 = global_5.member[bitcast<u32>(select(0i, _e2715, (_e2715 > 0i)))];
let _e2727 = ((_e2709 >> bitcast<u32>((_e2702 & 31u))) | ((_e2720 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2702) & 31u))));
let _e2730 = f32(bitcast<i32>((_e2727 & 65535u)));
let _e2737 = (_e2730 + ((f32(bitcast<i32>((_e2727 >> bitcast<u32>(16i)))) - _e2730) * _e2692));
let _e2739 = (2i * (_e2690 + _e2652));
let _e2741 = (_e2739 >> bitcast<u32>(2i));
let _e2744 = bitcast<u32>(((_e2739 & 3i) * 8i));
let _e2746 = select(_e2311, _e2741, (_e2741 < _e2311));
let _e2751 = global_5.member[bitcast<u32>(select(0i, _e2746, (_e2746 > 0i)))];
let _e2755 = (_e2741 + 1i);
let _e2757 = select(_e2311, _e2755, (_e2755 < _e2311));
let _e2762 = global_5.member[bitcast<u32>(select(0i, _e2757, (_e2757 > 0i)))];
let _e2769 = ((_e2751 >> bitcast<u32>((_e2744 & 31u))) | ((_e2762 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2744) & 31u))));
let _e2772 = f32(bitcast<i32>((_e2769 & 65535u)));
let _e2780 = (_e2690 + _e2677);
let _e2781 = (2i * _e2780);
let _e2783 = (_e2781 >> bitcast<u32>(2i));
let _e2786 = bitcast<u32>(((_e2781 & 3i) * 8i));
let _e2788 = select(_e2311, _e2783, (_e2783 < _e2311));
let _e2793 = global_5.member[bitcast<u32>(select(0i, _e2788, (_e2788 > 0i)))];
let _e2797 = (_e2783 + 1i);
let _e2799 = select(_e2311, _e2797, (_e2797 < _e2311));
let _e2804 = global_5.member[bitcast<u32>(select(0i, _e2799, (_e2799 > 0i)))];
let _e2811 = ((_e2793 >> bitcast<u32>((_e2786 & 31u))) | ((_e2804 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2786) & 31u))));
let _e2814 = f32(bitcast<i32>((_e2811 & 65535u)));
let _e2821 = (_e2814 + ((f32(bitcast<i32>((_e2811 >> bitcast<u32>(16i)))) - _e2814) * _e2692));
let _e2823 = (2i * (_e2780 + _e2652));
let _e2825 = (_e2823 >> bitcast<u32>(2i));
let _e2828 = bitcast<u32>(((_e2823 & 3i) * 8i));
let _e2830 = select(_e2311, _e2825, (_e2825 < _e2311));
let _e2835 = global_5.member[bitcast<u32>(select(0i, _e2830, (_e2830 > 0i)))];
let _e2839 = (_e2825 + 1i);
let _e2841 = select(_e2311, _e2839, (_e2839 < _e2311));
let _e2846 = global_5.member[bitcast<u32>(select(0i, _e2841, (_e2841 > 0i)))];
let _e2853 = ((_e2835 >> bitcast<u32>((_e2828 & 31u))) | ((_e2846 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2828) & 31u))));
let _e2856 = f32(bitcast<i32>((_e2853 & 65535u)));
let _e2866 = (_e2737 + (((_e2772 + ((f32(bitcast<i32>((_e2769 >> bitcast<u32>(16i)))) - _e2772) * _e2692)) - _e2737) * _e2694));
phi_4007_ = (_e2866 + (((_e2821 + (((_e2856 + ((f32(bitcast<i32>((_e2853 >> bitcast<u32>(16i)))) - _e2856) * _e2692)) - _e2821) * _e2694)) - _e2866) * (_e2574 - f32(_e2619))));
} else {
phi_4007_ = 0f;
}
let _e2874 = phi_4007_;
let _e2875 = (_e2564 - _e2874);
let _e2876 = local;
let _e2877 = local_1[0u];
let _e2879 = local_1[1u];
let _e2881 = local_1[2u];
let _e2883 = ((_e2877 + 0f) - 0.5f);
let _e2884 = ((_e2879 + -1f) - 0.5f);
let _e2885 = ((_e2881 + 0f) - 0.5f);
let _e2887 = select(0f, _e2883, (_e2883 > 0f));
let _e2889 = select(_e2258, _e2887, (_e2887 < _e2258));
let _e2896 = select(0i, select(select(i32(_e2889), i32(-2147483648), (_e2889 < -2147483600f)), 2147483647i, (_e2889 > 2147483500f)), (_e2889 == _e2889));
let _e2900 = (_e2896 - select(0i, 1i, (_e2889 < f32(_e2896))));
let _e2902 = select(0f, _e2884, (_e2884 > 0f));
let _e2904 = select(_e2275, _e2902, (_e2902 < _e2275));
let _e2911 = select(0i, select(select(i32(_e2904), i32(-2147483648), (_e2904 < -2147483600f)), 2147483647i, (_e2904 > 2147483500f)), (_e2904 == _e2904));
let _e2915 = (_e2911 - select(0i, 1i, (_e2904 < f32(_e2911))));
let _e2917 = select(0f, _e2885, (_e2885 > 0f));
let _e2919 = select(_e2292, _e2917, (_e2917 < _e2292));
let _e2926 = select(0i, select(select(i32(_e2919), i32(-2147483648), (_e2919 < -2147483600f)), 2147483647i, (_e2919 > 2147483500f)), (_e2919 == _e2919));
let _e2930 = (_e2926 - select(0i, 1i, (_e2919 < f32(_e2926))));
let _e2931 = (_e2876 * 4i);
let _e2932 = (_e2931 + 1i);
let _e2934 = select(_e2311, _e2932, (_e2932 < _e2311));
let _e2939 = global_5.member[bitcast<u32>(select(0i, _e2934, (_e2934 > 0i)))];
let _e2940 = (_e2931 + 2i);
let _e2942 = select(_e2311, _e2940, (_e2940 < _e2311));
let _e2947 = global_5.member[bitcast<u32>(select(0i, _e2942, (_e2942 > 0i)))];
let _e2948 = (_e2931 + 3i);
let _e2950 = select(_e2311, _e2948, (_e2948 < _e2311));
let _e2955 = global_5.member[bitcast<u32>(select(0i, _e2950, (_e2950 > 0i)))];
let _e2958 = (_e2900 - bitcast<i32>((_e2939 & 65535u)));
let _e2963 = bitcast<i32>((_e2939 >> bitcast<u32>(16i)));
let _e2968 = (_e2915 - bitcast<i32>((_e2947 & 65535u)));
let _e2973 = bitcast<i32>((_e2947 >> bitcast<u32>(16i)));
let _e2978 = (_e2930 - bitcast<i32>((_e2955 & 65535u)));
if ((((_e2958 >= 0i) && ((_e2958 + 1i) < _e2963)) && ((_e2968 >= 0i) && ((_e2968 + 1i) < _e2973))) && ((_e2978 >= 0i) && ((_e2978 + 1i) < bitcast<i32>((_e2955 >> bitcast<u32>(16i)))))) {
let _e2988 = (_e2973 * _e2963);
let _e2990 = select(_e2311, _e2931, (_e2931 < _e2311));
let _e2995 = global_5.member[bitcast<u32>(select(0i, _e2990, (_e2990 > 0i)))];
let _e3001 = (((bitcast<i32>(_e2995) + (_e2978 * _e2988)) + (_e2968 * _e2963)) + _e2958);
let _e3003 = (_e2883 - f32(_e2900));
let _e3005 = (_e2884 - f32(_e2915));
let _e3008 = (2i * _e3001);
let _e3010 = (_e3008 >> bitcast<u32>(2i));
let _e3013 = bitcast<u32>(((_e3008 & 3i) * 8i));
let _e3015 = select(_e2311, _e3010, (_e3010 < _e2311));
let _e3020 = global_5.member[bitcast<u32>(select(0i, _e3015, (_e3015 > 0i)))];
let _e3024 = (_e3010 + 1i);
let _e3026 = select(_e2311, _e3024, (_e3024 < _e2311));
let _e3031 = global_5.member[bitcast<u32>(select(0i, _e3026, (_e3026 > 0i)))];
let _e3038 = ((_e3020 >> bitcast<u32>((_e3013 & 31u))) | ((_e3031 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3013) & 31u))));
let _e3041 = f32(bitcast<i32>((_e3038 & 65535u)));
let _e3048 = (_e3041 + ((f32(bitcast<i32>((_e3038 >> bitcast<u32>(16i)))) - _e3041) * _e3003));
let _e3050 = (2i * (_e3001 + _e2963));
let _e3052 = (_e3050 >> bitcast<u32>(2i));
let _e3055 = bitcast<u32>(((_e3050 & 3i) * 8i));
let _e3057 = select(_e2311, _e3052, (_e3052 < _e2311));
let _e3062 = global_5.member[bitcast<u32>(select(0i, _e3057, (_e3057 > 0i)))];
let _e3066 = (_e3052 + 1i);
let _e3068 = select(_e2311, _e3066, (_e3066 < _e2311));
let _e3073 = global_5.member[bitcast<u32>(select(0i, _e3068, (_e3068 > 0i)))];
let _e3080 = ((_e3062 >> bitcast<u32>((_e3055 & 31u))) | ((_e3073 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3055) & 31u))));
let _e3083 = f32(bitcast<i32>((_e3080 & 65535u)));
let _e3091 = (_e3001 + _e2988);
let _e3092 = (2i * _e3091);
let _e3094 = (_e3092 >> bitcast<u32>(2i));
let _e3097 = bitcast<u32>(((_e3092 & 3i) * 8i));
let _e3099 = select(_e2311, _e3094, (_e3094 < _e2311));
let _e3104 = global_5.member[bitcast<u32>(select(0i, _e3099, (_e3099 > 0i)))];
let _e3108 = (_e3094 + 1i);
let _e3110 = select(_e2311, _e3108, (_e3108 < _e2311));
let _e3115 = global_5.member[bitcast<u32>(select(0i, _e3110, (_e3110 > 0i)))];
let _e3122 = ((_e3104 >> bitcast<u32>((_e3097 & 31u))) | ((_e3115 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3097) & 31u))));
let _e3125 = f32(bitcast<i32>((_e3122 & 65535u)));
let _e3132 = (_e3125 + ((f32(bitcast<i32>((_e3122 >> bitcast<u32>(16i)))) - _e3125) * _e3003));
let _e3134 = (2i * (_e3091 + _e2963));
let _e3136 = (_e3134 >> bitcast<u32>(2i));
let _e3139 = bitcast<u32>(((_e3134 & 3i) * 8i));
let _e3141 = select(_e2311, _e3136, (_e3136 < _e2311));
let _e3146 = global_5.member[bitcast<u32>(select(0i, _e3141, (_e3141 > 0i)))];
let _e3150 = (_e3136 + 1i);
let _e3152 = select(_e2311, _e3150, (_e3150 < _e2311));
let _e3157 = global_5.member[bitcast<u32>(select(0i, _e3152, (_e3152 > 0i)))];
let _e3164 = ((_e3146 >> bitcast<u32>((_e3139 & 31u))) | ((_e3157 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3139) & 31u))));
let _e3167 = f32(bitcast<i32>((_e3164 & 65535u)));
let _e3177 = (_e3048 + (((_e3083 + ((f32(bitcast<i32>((_e3080 >> bitcast<u32>(16i)))) - _e3083) * _e3003)) - _e3048) * _e3005));
phi_4447_ = (_e3177 + (((_e3132 + (((_e3167 + ((f32(bitcast<i32>((_e3164 >> bitcast<u32>(16i)))) - _e3167) * _e3003)) - _e3132) * _e3005)) - _e3177) * (_e2885 - f32(_e2930))));
} else {
phi_4447_ = 0f;
}
let _e3185 = phi_4447_;
let _e3186 = local;
let _e3187 = local_1[0u];
let _e3189 = local_1[1u];
let _e3191 = local_1[2u];
let _e3193 = ((_e3187 + 0f) - 0.5f);
let _e3194 = ((_e3189 + 1f) - 0.5f);
let _e3195 = ((_e3191 + 0f) - 0.5f);
let _e3197 = select(0f, _e3193, (_e3193 > 0f));
let _e3199 = select(_e2258, _e3197, (_e3197 < _e2258));
let _e3206 = select(0i, select(select(i32(_e3199), i32(-2147483648), (_e3199 < -2147483600f)), 2147483647i, (_e3199 > 2147483500f)), (_e3199 == _e3199));
let _e3210 = (_e3206 - select(0i, 1i, (_e3199 < f32(_e3206))));
let _e3212 = select(0f, _e3194, (_e3194 > 0f));
let _e3214 = select(_e2275, _e3212, (_e3212 < _e2275));
let _e3221 = select(0i, select(select(i32(_e3214), i32(-2147483648), (_e3214 < -2147483600f)), 2147483647i, (_e3214 > 2147483500f)), (_e3214 == _e3214));
let _e3225 = (_e3221 - select(0i, 1i, (_e3214 < f32(_e3221))));
let _e3227 = select(0f, _e3195, (_e3195 > 0f));
let _e3229 = select(_e2292, _e3227, (_e3227 < _e2292));
let _e3236 = select(0i, select(select(i32(_e3229), i32(-2147483648), (_e3229 < -2147483600f)), 2147483647i, (_e3229 > 2147483500f)), (_e3229 == _e3229));
let _e3240 = (_e3236 - select(0i, 1i, (_e3229 < f32(_e3236))));
let _e3241 = (_e3186 * 4i);
let _e3242 = (_e3241 + 1i);
let _e3244 = select(_e2311, _e3242, (_e3242 < _e2311));
let _e3249 = global_5.member[bitcast<u32>(select(0i, _e3244, (_e3244 > 0i)))];
let _e3250 = (_e3241 + 2i);
let _e3252 = select(_e2311, _e3250, (_e3250 < _e2311));
let _e3257 = global_5.member[bitcast<u32>(select(0i, _e3252, (_e3252 > 0i)))];
let _e3258 = (_e3241 + 3i);
let _e3260 = select(_e2311, _e3258, (_e3258 < _e2311));
let _e3265 = global_5.member[bitcast<u32>(select(0i, _e3260, (_e3260 > 0i)))];
let _e3268 = (_e3210 - bitcast<i32>((_e3249 & 65535u)));
let _e3273 = bitcast<i32>((_e3249 >> bitcast<u32>(16i)));
let _e3278 = (_e3225 - bitcast<i32>((_e3257 & 65535u)));
let _e3283 = bitcast<i32>((_e3257 >> bitcast<u32>(16i)));
let _e3288 = (_e3240 - bitcast<i32>((_e3265 & 65535u)));
if ((((_e3268 >= 0i) && ((_e3268 + 1i) < _e3273)) && ((_e3278 >= 0i) && ((_e3278 + 1i) < _e3283))) && ((_e3288 >= 0i) && ((_e3288 + 1i) < bitcast<i32>((_e3265 >> bitcast<u32>(16i)))))) {
let _e3298 = (_e3283 * _e3273);
let _e3300 = select(_e2311, _e3241, (_e3241 < _e2311));
let _e3305 = global_5.member[bitcast<u32>(select(0i, _e3300, (_e3300 > 0i)))];
let _e3311 = (((bitcast<i32>(_e3305) + (_e3288 * _e3298)) + (_e3278 * _e3273)) + _e3268);
let _e3313 = (_e3193 - f32(_e3210));
let _e3315 = (_e3194 - f32(_e3225));
let _e3318 = (2i * _e3311);
let _e3320 = (_e3318 >> bitcast<u32>(2i));
let _e3323 = bitcast<u32>(((_e3318 & 3i) * 8i));
let _e3325 = select(_e2311, _e3320, (_e3320 < _e2311));
let _e3330 = global_5.member[bitcast<u32>(select(0i, _e3325, (_e3325 > 0i)))];
let _e3334 = (_e3320 + 1i);
let _e3336 = select(_e2311, _e3334, (_e3334 < _e2311));
let _e3341 = global_5.member[bitcast<u32>(select(0i, _e3336, (_e3336 > 0i)))];
let _e3348 = ((_e3330 >> bitcast<u32>((_e3323 & 31u))) | ((_e3341 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3323) & 31u))));
let _e3351 = f32(bitcast<i32>((_e3348 & 65535u)));
let _e3358 = (_e3351 + ((f32(bitcast<i32>((_e3348 >> bitcast<u32>(16i)))) - _e3351) * _e3313));
let _e3360 = (2i * (_e3311 + _e3273));
let _e3362 = (_e3360 >> bitcast<u32>(2i));
let _e3365 = bitcast<u32>(((_e3360 & 3i) * 8i));
let _e3367 = select(_e2311, _e3362, (_e3362 < _e2311));
let _e3372 = global_5.member[bitcast<u32>(select(0i, _e3367, (_e3367 > 0i)))];
let _e3376 = (_e3362 + 1i);
let _e3378 = select(_e2311, _e3376, (_e3376 < _e2311));
let _e3383 = global_5.member[bitcast<u32>(select(0i, _e3378, (_e3378 > 0i)))];
let _e3390 = ((_e3372 >> bitcast<u32>((_e3365 & 31u))) | ((_e3383 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3365) & 31u))));
let _e3393 = f32(bitcast<i32>((_e3390 & 65535u)));
let _e3401 = (_e3311 + _e3298);
let _e3402 = (2i * _e3401);
let _e3404 = (_e3402 >> bitcast<u32>(2i));
let _e3407 = bitcast<u32>(((_e3402 & 3i) * 8i));
let _e3409 = select(_e2311, _e3404, (_e3404 < _e2311));
let _e3414 = global_5.member[bitcast<u32>(select(0i, _e3409, (_e3409 > 0i)))];
let _e3418 = (_e3404 + 1i);
let _e3420 = select(_e2311, _e3418, (_e3418 < _e2311));
let _e3425 = global_5.member[bitcast<u32>(select(0i, _e3420, (_e3420 > 0i)))];
let _e3432 = ((_e3414 >> bitcast<u32>((_e3407 & 31u))) | ((_e3425 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3407) & 31u))));
let _e3435 = f32(bitcast<i32>((_e3432 & 65535u)));
let _e3442 = (_e3435 + ((f32(bitcast<i32>((_e3432 >> bitcast<u32>(16i)))) - _e3435) * _e3313));
let _e3444 = (2i * (_e3401 + _e3273));
let _e3446 = (_e3444 >> bitcast<u32>(2i));
let _e3449 = bitcast<u32>(((_e3444 & 3i) * 8i));
let _e3451 = select(_e2311, _e3446, (_e3446 < _e2311));
let _e3456 = global_5.member[bitcast<u32>(select(0i, _e3451, (_e3451 > 0i)))];
let _e3460 = (_e3446 + 1i);
let _e3462 = select(_e2311, _e3460, (_e3460 < _e2311));
let _e3467 = global_5.member[bitcast<u32>(select(0i, _e3462, (_e3462 > 0i)))];
let _e3474 = ((_e3456 >> bitcast<u32>((_e3449 & 31u))) | ((_e3467 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3449) & 31u))));
let _e3477 = f32(bitcast<i32>((_e3474 & 65535u)));
let _e3487 = (_e3358 + (((_e3393 + ((f32(bitcast<i32>((_e3390 >> bitcast<u32>(16i)))) - _e3393) * _e3313)) - _e3358) * _e3315));
phi_4886_ = (_e3487 + (((_e3442 + (((_e3477 + ((f32(bitcast<i32>((_e3474 >> bitcast<u32>(16i)))) - _e3477) * _e3313)) - _e3442) * _e3315)) - _e3487) * (_e3195 - f32(_e3240))));
} else {
phi_4886_ = 0f;
}
let _e3495 = phi_4886_;
let _e3496 = (_e3185 - _e3495);
let _e3497 = local;
let _e3498 = local_1[0u];
let _e3500 = local_1[1u];
let _e3502 = local_1[2u];
let _e3504 = ((_e3498 + 0f) - 0.5f);
let _e3505 = ((_e3500 + 0f) - 0.5f);
let _e3506 = ((_e3502 + -1f) - 0.5f);
let _e3508 = select(0f, _e3504, (_e3504 > 0f));
let _e3510 = select(_e2258, _e3508, (_e3508 < _e2258));
let _e3517 = select(0i, select(select(i32(_e3510), i32(-2147483648), (_e3510 < -2147483600f)), 2147483647i, (_e3510 > 2147483500f)), (_e3510 == _e3510));
let _e3521 = (_e3517 - select(0i, 1i, (_e3510 < f32(_e3517))));
let _e3523 = select(0f, _e3505, (_e3505 > 0f));
let _e3525 = select(_e2275, _e3523, (_e3523 < _e2275));
let _e3532 = select(0i, select(select(i32(_e3525), i32(-2147483648), (_e3525 < -2147483600f)), 2147483647i, (_e3525 > 2147483500f)), (_e3525 == _e3525));
let _e3536 = (_e3532 - select(0i, 1i, (_e3525 < f32(_e3532))));
let _e3538 = select(0f, _e3506, (_e3506 > 0f));
let _e3540 = select(_e2292, _e3538, (_e3538 < _e2292));
let _e3547 = select(0i, select(select(i32(_e3540), i32(-2147483648), (_e3540 < -2147483600f)), 2147483647i, (_e3540 > 2147483500f)), (_e3540 == _e3540));
let _e3551 = (_e3547 - select(0i, 1i, (_e3540 < f32(_e3547))));
let _e3552 = (_e3497 * 4i);
let _e3553 = (_e3552 + 1i);
let _e3555 = select(_e2311, _e3553, (_e3553 < _e2311));
let _e3560 = global_5.member[bitcast<u32>(select(0i, _e3555, (_e3555 > 0i)))];
let _e3561 = (_e3552 + 2i);
let _e3563 = select(_e2311, _e3561, (_e3561 < _e2311));
let _e3568 = global_5.member[bitcast<u32>(select(0i, _e3563, (_e3563 > 0i)))];
let _e3569 = (_e3552 + 3i);
let _e3571 = select(_e2311, _e3569, (_e3569 < _e2311));
let _e3576 = global_5.member[bitcast<u32>(select(0i, _e3571, (_e3571 > 0i)))];
let _e3579 = (_e3521 - bitcast<i32>((_e3560 & 65535u)));
let _e3584 = bitcast<i32>((_e3560 >> bitcast<u32>(16i)));
let _e3589 = (_e3536 - bitcast<i32>((_e3568 & 65535u)));
let _e3594 = bitcast<i32>((_e3568 >> bitcast<u32>(16i)));
let _e3599 = (_e3551 - bitcast<i32>((_e3576 & 65535u)));
if ((((_e3579 >= 0i) && ((_e3579 + 1i) < _e3584)) && ((_e3589 >= 0i) && ((_e3589 + 1i) < _e3594))) && ((_e3599 >= 0i) && ((_e3599 + 1i) < bitcast<i32>((_e3576 >> bitcast<u32>(16i)))))) {
let _e3609 = (_e3594 * _e3584);
let _e3611 = select(_e2311, _e3552, (_e3552 < _e2311));
let _e3616 = global_5.member[bitcast<u32>(select(0i, _e3611, (_e3611 > 0i)))];
let _e3622 = (((bitcast<i32>(_e3616) + (_e3599 * _e3609)) + (_e3589 * _e3584)) + _e3579);
let _e3624 = (_e3504 - f32(_e3521));
let _e3626 = (_e3505 - f32(_e3536));
let _e3629 = (2i * _e3622);
let _e3631 = (_e3629 >> bitcast<u32>(2i));
let _e3634 = bitcast<u32>(((_e3629 & 3i) * 8i));
let _e3636 = select(_e2311, _e3631, (_e3631 < _e2311));
let _e3641 = global_5.member[bitcast<u32>(select(0i, _e3636, (_e3636 > 0i)))];
let _e3645 = (_e3631 + 1i);
let _e3647 = select(_e2311, _e3645, (_e3645 < _e2311));
let _e3652 = global_5.member[bitcast<u32>(select(0i, _e3647, (_e3647 > 0i)))];
let _e3659 = ((_e3641 >> bitcast<u32>((_e3634 & 31u))) | ((_e3652 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3634) & 31u))));
let _e3662 = f32(bitcast<i32>((_e3659 & 65535u)));
let _e3669 = (_e3662 + ((f32(bitcast<i32>((_e3659 >> bitcast<u32>(16i)))) - _e3662) * _e3624));
let _e3671 = (2i * (_e3622 + _e3584));
let _e3673 = (_e3671 >> bitcast<u32>(2i));
let _e3676 = bitcast<u32>(((_e3671 & 3i) * 8i));
let _e3678 = select(_e2311, _e3673, (_e3673 < _e2311));
let _e3683 = global_5.member[bitcast<u32>(select(0i, _e3678, (_e3678 > 0i)))];
let _e3687 = (_e3673 + 1i);
let _e3689 = select(_e2311, _e3687, (_e3687 < _e2311));
let _e3694 = global_5.member[bitcast<u32>(select(0i, _e3689, (_e3689 > 0i)))];
let _e3701 = ((_e3683 >> bitcast<u32>((_e3676 & 31u))) | ((_e3694 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3676) & 31u))));
let _e3704 = f32(bitcast<i32>((_e3701 & 65535u)));
let _e3712 = (_e3622 + _e3609);
let _e3713 = (2i * _e3712);
let _e3715 = (_e3713 >> bitcast<u32>(2i));
let _e3718 = bitcast<u32>(((_e3713 & 3i) * 8i));
let _e3720 = select(_e2311, _e3715, (_e3715 < _e2311));
let _e3725 = global_5.member[bitcast<u32>(select(0i, _e3720, (_e3720 > 0i)))];
let _e3729 = (_e3715 + 1i);
let _e3731 = select(_e2311, _e3729, (_e3729 < _e2311));
let _e3736 = global_5.member[bitcast<u32>(select(0i, _e3731, (_e3731 > 0i)))];
let _e3743 = ((_e3725 >> bitcast<u32>((_e3718 & 31u))) | ((_e3736 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3718) & 31u))));
let _e3746 = f32(bitcast<i32>((_e3743 & 65535u)));
let _e3753 = (_e3746 + ((f32(bitcast<i32>((_e3743 >> bitcast<u32>(16i)))) - _e3746) * _e3624));
let _e3755 = (2i * (_e3712 + _e3584));
let _e3757 = (_e3755 >> bitcast<u32>(2i));
let _e3760 = bitcast<u32>(((_e3755 & 3i) * 8i));
let _e3762 = select(_e2311, _e3757, (_e3757 < _e2311));
let _e3767 = global_5.member[bitcast<u32>(select(0i, _e3762, (_e3762 > 0i)))];
let _e3771 = (_e3757 + 1i);
let _e3773 = select(_e2311, _e3771, (_e3771 < _e2311));
let _e3778 = global_5.member[bitcast<u32>(select(0i, _e3773, (_e3773 > 0i)))];
let _e3785 = ((_e3767 >> bitcast<u32>((_e3760 & 31u))) | ((_e3778 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3760) & 31u))));
let _e3788 = f32(bitcast<i32>((_e3785 & 65535u)));
let _e3798 = (_e3669 + (((_e3704 + ((f32(bitcast<i32>((_e3701 >> bitcast<u32>(16i)))) - _e3704) * _e3624)) - _e3669) * _e3626));
phi_5326_ = (_e3798 + (((_e3753 + (((_e3788 + ((f32(bitcast<i32>((_e3785 >> bitcast<u32>(16i)))) - _e3788) * _e3624)) - _e3753) * _e3626)) - _e3798) * (_e3506 - f32(_e3551))));
} else {
phi_5326_ = 0f;
}
let _e3806 = phi_5326_;
let _e3807 = local;
let _e3808 = local_1[0u];
let _e3810 = local_1[1u];
let _e3812 = local_1[2u];
let _e3814 = ((_e3808 + 0f) - 0.5f);
let _e3815 = ((_e3810 + 0f) - 0.5f);
let _e3816 = ((_e3812 + 1f) - 0.5f);
let _e3818 = select(0f, _e3814, (_e3814 > 0f));
let _e3820 = select(_e2258, _e3818, (_e3818 < _e2258));
let _e3827 = select(0i, select(select(i32(_e3820), i32(-2147483648), (_e3820 < -2147483600f)), 2147483647i, (_e3820 > 2147483500f)), (_e3820 == _e3820));
let _e3831 = (_e3827 - select(0i, 1i, (_e3820 < f32(_e3827))));
let _e3833 = select(0f, _e3815, (_e3815 > 0f));
let _e3835 = select(_e2275, _e3833, (_e3833 < _e2275));
let _e3842 = select(0i, select(select(i32(_e3835), i32(-2147483648), (_e3835 < -2147483600f)), 2147483647i, (_e3835 > 2147483500f)), (_e3835 == _e3835));
let _e3846 = (_e3842 - select(0i, 1i, (_e3835 < f32(_e3842))));
let _e3848 = select(0f, _e3816, (_e3816 > 0f));
let _e3850 = select(_e2292, _e3848, (_e3848 < _e2292));
let _e3857 = select(0i, select(select(i32(_e3850), i32(-2147483648), (_e3850 < -2147483600f)), 2147483647i, (_e3850 > 2147483500f)), (_e3850 == _e3850));
let _e3861 = (_e3857 - select(0i, 1i, (_e3850 < f32(_e3857))));
let _e3862 = (_e3807 * 4i);
let _e3863 = (_e3862 + 1i);
let _e3865 = select(_e2311, _e3863, (_e3863 < _e2311));
let _e3870 = global_5.member[bitcast<u32>(select(0i, _e3865, (_e3865 > 0i)))];
let _e3871 = (_e3862 + 2i);
let _e3873 = select(_e2311, _e3871, (_e3871 < _e2311));
let _e3878 = global_5.member[bitcast<u32>(select(0i, _e3873, (_e3873 > 0i)))];
let _e3879 = (_e3862 + 3i);
let _e3881 = select(_e2311, _e3879, (_e3879 < _e2311));
let _e3886 = global_5.member[bitcast<u32>(select(0i, _e3881, (_e3881 > 0i)))];
let _e3889 = (_e3831 - bitcast<i32>((_e3870 & 65535u)));
let _e3894 = bitcast<i32>((_e3870 >> bitcast<u32>(16i)));
let _e3899 = (_e3846 - bitcast<i32>((_e3878 & 65535u)));
let _e3904 = bitcast<i32>((_e3878 >> bitcast<u32>(16i)));
let _e3909 = (_e3861 - bitcast<i32>((_e3886 & 65535u)));
if ((((_e3889 >= 0i) && ((_e3889 + 1i) < _e3894)) && ((_e3899 >= 0i) && ((_e3899 + 1i) < _e3904))) && ((_e3909 >= 0i) && ((_e3909 + 1i) < bitcast<i32>((_e3886 >> bitcast<u32>(16i)))))) {
let _e3919 = (_e3904 * _e3894);
let _e3921 = select(_e2311, _e3862, (_e3862 < _e2311));
let _e3926 = global_5.member[bitcast<u32>(select(0i, _e3921, (_e3921 > 0i)))];
let _e3932 = (((bitcast<i32>(_e3926) + (_e3909 * _e3919)) + (_e3899 * _e3894)) + _e3889);
let _e3934 = (_e3814 - f32(_e3831));
let _e3936 = (_e3815 - f32(_e3846));
let _e3939 = (2i * _e3932);
let _e3941 = (_e3939 >> bitcast<u32>(2i));
let _e3944 = bitcast<u32>(((_e3939 & 3i) * 8i));
let _e3946 = select(_e2311, _e3941, (_e3941 < _e2311));
let _e3951 = global_5.member[bitcast<u32>(select(0i, _e3946, (_e3946 > 0i)))];
let _e3955 = (_e3941 + 1i);
let _e3957 = select(_e2311, _e3955, (_e3955 < _e2311));
let _e3962 = global_5.member[bitcast<u32>(select(0i, _e3957, (_e3957 > 0i)))];
let _e3969 = ((_e3951 >> bitcast<u32>((_e3944 & 31u))) | ((_e3962 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3944) & 31u))));
let _e3972 = f32(bitcast<i32>((_e3969 & 65535u)));
let _e3979 = (_e3972 + ((f32(bitcast<i32>((_e3969 >> bitcast<u32>(16i)))) - _e3972) * _e3934));
let _e3981 = (2i * (_e3932 + _e3894));
let _e3983 = (_e3981 >> bitcast<u32>(2i));
let _e3986 = bitcast<u32>(((_e3981 & 3i) * 8i));
let _e3988 = select(_e2311, _e3983, (_e3983 < _e2311));
let _e3993 = global_5.member[bitcast<u32>(select(0i, _e3988, (_e3988 > 0i)))];
let _e3997 = (_e3983 + 1i);
let _e3999 = select(_e2311, _e3997, (_e3997 < _e2311));
let _e4004 = global_5.member[bitcast<u32>(select(0i, _e3999, (_e3999 > 0i)))];
let _e4011 = ((_e3993 >> bitcast<u32>((_e3986 & 31u))) | ((_e4004 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3986) & 31u))));
let _e4014 = f32(bitcast<i32>((_e4011 & 65535u)));
let _e4022 = (_e3932 + _e3919);
let _e4023 = (2i * _e4022);
let _e4025 = (_e4023 >> bitcast<u32>(2i));
let _e4028 = bitcast<u32>(((_e4023 & 3i) * 8i));
let _e4030 = select(_e2311, _e4025, (_e4025 < _e2311));
let _e4035 = global_5.member[bitcast<u32>(select(0i, _e4030, (_e4030 > 0i)))];
let _e4039 = (_e4025 + 1i);
let _e4041 = select(_e2311, _e4039, (_e4039 < _e2311));
let _e4046 = global_5.member[bitcast<u32>(select(0i, _e4041, (_e4041 > 0i)))];
let _e4053 = ((_e4035 >> bitcast<u32>((_e4028 & 31u))) | ((_e4046 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4028) & 31u))));
let _e4056 = f32(bitcast<i32>((_e4053 & 65535u)));
let _e4063 = (_e4056 + ((f32(bitcast<i32>((_e4053 >> bitcast<u32>(16i)))) - _e4056) * _e3934));
let _e4065 = (2i * (_e4022 + _e3894));
let _e4067 = (_e4065 >> bitcast<u32>(2i));
let _e4070 = bitcast<u32>(((_e4065 & 3i) * 8i));
let _e4072 = select(_e2311, _e4067, (_e4067 < _e2311));
let _e4077 = global_5.member[bitcast<u32>(select(0i, _e4072, (_e4072 > 0i)))];
let _e4081 = (_e4067 + 1i);
let _e4083 = select(_e2311, _e4081, (_e4081 < _e2311));
let _e4088 = global_5.member[bitcast<u32>(select(0i, _e4083, (_e4083 > 0i)))];
let _e4095 = ((_e4077 >> bitcast<u32>((_e4070 & 31u))) | ((_e4088 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4070) & 31u))));
let _e4098 = f32(bitcast<i32>((_e4095 & 65535u)));
let _e4108 = (_e3979 + (((_e4014 + ((f32(bitcast<i32>((_e4011 >> bitcast<u32>(16i)))) - _e4014) * _e3934)) - _e3979) * _e3936));
phi_5765_ = (_e4108 + (((_e4063 + (((_e4098 + ((f32(bitcast<i32>((_e4095 >> bitcast<u32>(16i)))) - _e4098) * _e3934)) - _e4063) * _e3936)) - _e4108) * (_e3816 - f32(_e3861))));
} else {
phi_5765_ = 0f;
}
let _e4116 = phi_5765_;
let _e4117 = (_e3806 - _e4116);
let _e4122 = (((_e2875 * _e2875) + (_e3496 * _e3496)) + (_e4117 * _e4117));
let _e4125 = sqrt(select(0f, _e4122, (_e4122 > 0f)));
let _e4128 = (1f / select(1e-6f, _e4125, (_e4125 > 1e-6f)));
let _e4129 = (_e2875 * _e4128);
let _e4130 = (_e3496 * _e4128);
let _e4131 = (_e4117 * _e4128);
let _e4132 = vec3<f32>(_e4129, _e4130, _e4131);
let _e4135 = local_10;
let _e4136 = (_e904.member_5 + _e4135);
let _e4139 = global_1.member.member_13;
let _e4152 = global_1.member.member_12;
let _e4156 = local_11;
let _e4158 = (((_e4136 < _e4139) && ((((_e4129 * _e904.member_4.x) + (_e4130 * _e904.member_4.y)) + (_e4131 * _e904.member_4.z)) > _e4152)) || (_e4156 == _e904.member_7));
if _e4158 {
phi_7298_ = _e904;
} else {
let _e4186 = type_20(vec3<f32>((_e904.member.x + _e1863), (_e904.member.y + _e1866), (_e904.member.z + _e1869)), _e904.member_1, _e904.member_2, _e904.member_3, _e904.member_4, _e904.member_5, _e904.member_6, _e904.member_7, _e904.member_8, _e904.member_9, _e904.member_10, _e904.member_11, _e904.member_12, _e904.member_13, _e904.member_14, _e904.member_15, _e904.member_16, _e904.member_17);
let _e4204 = type_20(_e4186.member, _e4186.member_1, _e4186.member_2, _e4186.member_3, _e4186.member_4, _e4136, _e4186.member_6, _e4186.member_7, _e4186.member_8, _e4186.member_9, _e4186.member_10, _e4186.member_11, _e4186.member_12, _e4186.member_13, _e4186.member_14, _e4186.member_15, _e4186.member_16, _e4186.member_17);
let _e4208 = local_12;
let _e4229 = type_20(_e4204.member, _e4204.member_1, _e4204.member_2, _e4204.member_3, _e4204.member_4, _e4204.member_5, _e4204.member_6, _e4204.member_7, _e4204.member_8, _e4204.member_9, (_e904.member_10 + select(0f, _e4208, (_e904.member_8 == 0f))), _e4204.member_11, _e4204.member_12, _e4204.member_13, _e4204.member_14, _e4204.member_15, _e4204.member_16, _e4204.member_17);
if (_e904.member_7 != 16i) {
let _e4233 = local_13;
let _e4252 = type_20(_e4229.member, _e4229.member_1, _e4229.member_2, _e4229.member_3, _e4229.member_4, _e4229.member_5, _e4229.member_6, _e4229.member_7, _e4229.member_8, (_e904.member_9 + _e4233), _e4229.member_10, _e4229.member_11, _e4229.member_12, _e4229.member_13, _e4229.member_14, _e4229.member_15, _e4229.member_16, _e4229.member_17);
let _e4253 = (_e904.member_7 * 4i);
let _e4254 = (_e4253 + 1i);
let _e4256 = (bitcast<i32>(_e103) - 1i);
let _e4258 = select(_e4256, _e4254, (_e4254 < _e4256));
let _e4264 = global_2.member[bitcast<u32>(select(0i, _e4258, (_e4258 > 0i)))];
let _e4266 = local_14;
let _e4268 = -((_e4264 * _e4266));
let _e4270 = select(-87f, _e4268, (_e4268 > -87f));
let _e4272 = select(88f, _e4270, (_e4270 < 88f));
let _e4274 = ((_e4272 * 1.442695f) + 0.5f);
let _e4276 = select(-127f, _e4274, (_e4274 > -127f));
let _e4278 = select(128f, _e4276, (_e4276 < 128f));
let _e4285 = select(0i, select(select(i32(_e4278), i32(-2147483648), (_e4278 < -2147483600f)), 2147483647i, (_e4278 > 2147483500f)), (_e4278 == _e4278));
let _e4289 = (_e4285 - select(0i, 1i, (_e4278 < f32(_e4285))));
let _e4290 = f32(_e4289);
let _e4294 = ((_e4272 - (_e4290 * 0.6933594f)) - (_e4290 * -2.1219444e-4f));
let _e4315 = (_e4253 + 2i);
let _e4317 = select(_e4256, _e4315, (_e4315 < _e4256));
let _e4323 = global_2.member[bitcast<u32>(select(0i, _e4317, (_e4317 > 0i)))];
let _e4325 = local_15;
let _e4327 = -((_e4323 * _e4325));
let _e4329 = select(-87f, _e4327, (_e4327 > -87f));
let _e4331 = select(88f, _e4329, (_e4329 < 88f));
let _e4333 = ((_e4331 * 1.442695f) + 0.5f);
let _e4335 = select(-127f, _e4333, (_e4333 > -127f));
let _e4337 = select(128f, _e4335, (_e4335 < 128f));
let _e4344 = select(0i, select(select(i32(_e4337), i32(-2147483648), (_e4337 < -2147483600f)), 2147483647i, (_e4337 > 2147483500f)), (_e4337 == _e4337));
let _e4348 = (_e4344 - select(0i, 1i, (_e4337 < f32(_e4344))));
let _e4349 = f32(_e4348);
let _e4353 = ((_e4331 - (_e4349 * 0.6933594f)) - (_e4349 * -2.1219444e-4f));
let _e4374 = (_e4253 + 3i);
let _e4376 = select(_e4256, _e4374, (_e4374 < _e4256));
let _e4382 = global_2.member[bitcast<u32>(select(0i, _e4376, (_e4376 > 0i)))];
let _e4384 = local_16;
let _e4386 = -((_e4382 * _e4384));
let _e4388 = select(-87f, _e4386, (_e4386 > -87f));
let _e4390 = select(88f, _e4388, (_e4388 < 88f));
let _e4392 = ((_e4390 * 1.442695f) + 0.5f);
let _e4394 = select(-127f, _e4392, (_e4392 > -127f));
let _e4396 = select(128f, _e4394, (_e4394 < 128f));
let _e4403 = select(0i, select(select(i32(_e4396), i32(-2147483648), (_e4396 < -2147483600f)), 2147483647i, (_e4396 > 2147483500f)), (_e4396 == _e4396));
let _e4407 = (_e4403 - select(0i, 1i, (_e4396 < f32(_e4403))));
let _e4408 = f32(_e4407);
let _e4412 = ((_e4390 - (_e4408 * 0.6933594f)) - (_e4408 * -2.1219444e-4f));
phi_6095_ = type_20(_e4252.member, _e4252.member_1, vec3<f32>((_e904.member_2.x * ((1f + (_e4294 * (1f + (_e4294 * (0.5f + (_e4294 * (0.16666667f + (_e4294 * (0.041666668f + (_e4294 * (0.008333334f + (_e4294 * (0.001388889f + (_e4294 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4289 + 127i)) << bitcast<u32>(23i))))), (_e904.member_2.y * ((1f + (_e4353 * (1f + (_e4353 * (0.5f + (_e4353 * (0.16666667f + (_e4353 * (0.041666668f + (_e4353 * (0.008333334f + (_e4353 * (0.001388889f + (_e4353 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4348 + 127i)) << bitcast<u32>(23i))))), (_e904.member_2.z * ((1f + (_e4412 * (1f + (_e4412 * (0.5f + (_e4412 * (0.16666667f + (_e4412 * (0.041666668f + (_e4412 * (0.008333334f + (_e4412 * (0.001388889f + (_e4412 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4407 + 127i)) << bitcast<u32>(23i)))))), _e4252.member_3, _e4252.member_4, _e4252.member_5, _e4252.member_6, _e4252.member_7, _e4252.member_8, _e4252.member_9, _e4252.member_10, _e4252.member_11, _e4252.member_12, _e4252.member_13, _e4252.member_14, _e4252.member_15, _e4252.member_16, _e4252.member_17);
} else {
phi_6095_ = _e4229;
}
let _e4462 = phi_6095_;
let _e4464 = (_e904.member_7 * 4i);
let _e4466 = (bitcast<i32>(_e103) - 1i);
let _e4468 = select(_e4466, _e4464, (_e4464 < _e4466));
let _e4474 = global_2.member[bitcast<u32>(select(0i, _e4468, (_e4468 > 0i)))];
let _e4475 = (_e904.member_7 == 16i);
let _e4476 = select(_e4474, 1f, _e4475);
let _e4478 = local_17;
let _e4479 = (_e4478 * 4i);
let _e4481 = select(_e4466, _e4479, (_e4479 < _e4466));
let _e4487 = global_2.member[bitcast<u32>(select(0i, _e4481, (_e4481 > 0i)))];
let _e4489 = local_18;
let _e4491 = select(_e4487, 1f, (_e4489 == 16i));
let _e4501 = select(1f, -1f, ((((_e4462.member_1.x * _e4129) + (_e4462.member_1.y * _e4130)) + (_e4462.member_1.z * _e4131)) > 0f));
let _e4502 = (_e4129 * _e4501);
let _e4503 = (_e4130 * _e4501);
let _e4504 = (_e4131 * _e4501);
let _e4510 = -((((_e4462.member_1.x * _e4502) + (_e4462.member_1.y * _e4503)) + (_e4462.member_1.z * _e4504)));
let _e4512 = select(0f, _e4510, (_e4510 > 0f));
let _e4513 = (_e4476 / _e4491);
let _e4515 = (_e4512 * _e4512);
let _e4518 = (1f - ((_e4513 * _e4513) * (1f - _e4515)));
let _e4519 = (_e4518 <= 0f);
let _e4527 = ((_e4513 * _e4512) - sqrt(select(0f, _e4518, (_e4518 > 0f))));
let _e4534 = (2f * _e4512);
let _e4538 = (_e4462.member_1.x + (_e4502 * _e4534));
let _e4539 = (_e4462.member_1.y + (_e4503 * _e4534));
let _e4540 = (_e4462.member_1.z + (_e4504 * _e4534));
let _e4541 = select(((_e4462.member_1.x * _e4513) + (_e4502 * _e4527)), _e4538, _e4519);
let _e4542 = select(((_e4462.member_1.y * _e4513) + (_e4503 * _e4527)), _e4539, _e4519);
let _e4543 = select(((_e4462.member_1.z * _e4513) + (_e4504 * _e4527)), _e4540, _e4519);
let _e4548 = (((_e4541 * _e4541) + (_e4542 * _e4542)) + (_e4543 * _e4543));
let _e4551 = sqrt(select(0f, _e4548, (_e4548 > 0f)));
let _e4554 = (1f / select(1e-20f, _e4551, (_e4551 > 1e-20f)));
let _e4559 = (_e4491 / _e4476);
let _e4562 = (((_e4559 * _e4559) - 1f) + _e4515);
let _e4565 = sqrt(select(0f, _e4562, (_e4562 > 0f)));
let _e4566 = (_e4565 - _e4512);
let _e4567 = (_e4565 + _e4512);
let _e4570 = (_e4566 / select(1e-6f, _e4567, (_e4567 > 1e-6f)));
let _e4574 = ((_e4512 * _e4566) + 1f);
let _e4577 = (((_e4512 * _e4567) - 1f) / select(1e-6f, _e4574, (_e4574 > 1e-6f)));
let _e4588 = (_e4462.member_8 == 0f);
let _e4591 = global_1.member.member_1;
let _e4594 = select(0f, select(select((((0.5f * _e4570) * _e4570) * (1f + (_e4577 * _e4577))), 1f, (_e4562 <= 0f)), 0f, (_e4476 == _e4491)), ((_e4591 & 1u) != 0u));
let _e4595 = (_e4588 && _e4475);
if _e4588 {
let _e4613 = type_20(_e4462.member, _e4462.member_1, _e4462.member_2, _e4132, _e4462.member_4, _e4462.member_5, _e4462.member_6, _e4462.member_7, _e4462.member_8, _e4462.member_9, _e4462.member_10, _e4462.member_11, _e4462.member_12, _e4462.member_13, _e4462.member_14, _e4462.member_15, _e4462.member_16, _e4462.member_17);
phi_6312_ = type_20(_e4613.member, _e4613.member_1, _e4613.member_2, _e4613.member_3, _e4613.member_4, _e4613.member_5, _e4613.member_6, _e4613.member_7, _e4613.member_8, _e4613.member_9, _e4613.member_10, select(0f, _e4594, _e4595), _e4613.member_12, _e4613.member_13, _e4613.member_14, _e4613.member_15, _e4613.member_16, _e4613.member_17);
} else {
phi_6312_ = _e4462;
}
let _e4634 = phi_6312_;
let _e4638 = select(24f, _e4634.member_8, (_e4634.member_8 < 24f));
let _e4648 = (_e4634.member_14 >> bitcast<u32>((select(0i, select(select(i32(_e4638), i32(-2147483648), (_e4638 < -2147483600f)), 2147483647i, (_e4638 > 2147483500f)), (_e4638 == _e4638)) & 31i)));
let _e4650 = ((_e4648 & 1i) == 1i);
if ((!(_e4595) && !(_e4519)) && (_e4648 == 0i)) {
let _e4659 = select(_e4634.member_5, _e4634.member_9, (_e4634.member_8 == 0f));
let _e4660 = (_e4464 + 1i);
let _e4662 = select(_e4466, _e4660, (_e4660 < _e4466));
let _e4668 = global_2.member[bitcast<u32>(select(0i, _e4662, (_e4662 > 0i)))];
let _e4670 = -((_e4668 * _e4659));
let _e4672 = select(-87f, _e4670, (_e4670 > -87f));
let _e4674 = select(88f, _e4672, (_e4672 < 88f));
let _e4676 = ((_e4674 * 1.442695f) + 0.5f);
let _e4678 = select(-127f, _e4676, (_e4676 > -127f));
let _e4680 = select(128f, _e4678, (_e4678 < 128f));
let _e4687 = select(0i, select(select(i32(_e4680), i32(-2147483648), (_e4680 < -2147483600f)), 2147483647i, (_e4680 > 2147483500f)), (_e4680 == _e4680));
let _e4691 = (_e4687 - select(0i, 1i, (_e4680 < f32(_e4687))));
let _e4692 = f32(_e4691);
let _e4696 = ((_e4674 - (_e4692 * 0.6933594f)) - (_e4692 * -2.1219444e-4f));
let _e4717 = (_e4464 + 2i);
let _e4719 = select(_e4466, _e4717, (_e4717 < _e4466));
let _e4725 = global_2.member[bitcast<u32>(select(0i, _e4719, (_e4719 > 0i)))];
let _e4727 = -((_e4725 * _e4659));
let _e4729 = select(-87f, _e4727, (_e4727 > -87f));
let _e4731 = select(88f, _e4729, (_e4729 < 88f));
let _e4733 = ((_e4731 * 1.442695f) + 0.5f);
let _e4735 = select(-127f, _e4733, (_e4733 > -127f));
let _e4737 = select(128f, _e4735, (_e4735 < 128f));
let _e4744 = select(0i, select(select(i32(_e4737), i32(-2147483648), (_e4737 < -2147483600f)), 2147483647i, (_e4737 > 2147483500f)), (_e4737 == _e4737));
let _e4748 = (_e4744 - select(0i, 1i, (_e4737 < f32(_e4744))));
let _e4749 = f32(_e4748);
let _e4753 = ((_e4731 - (_e4749 * 0.6933594f)) - (_e4749 * -2.1219444e-4f));
let _e4774 = (_e4464 + 3i);
let _e4776 = select(_e4466, _e4774, (_e4774 < _e4466));
let _e4782 = global_2.member[bitcast<u32>(select(0i, _e4776, (_e4776 > 0i)))];
let _e4784 = -((_e4782 * _e4659));
let _e4786 = select(-87f, _e4784, (_e4784 > -87f));
let _e4788 = select(88f, _e4786, (_e4786 < 88f));
let _e4790 = ((_e4788 * 1.442695f) + 0.5f);
let _e4792 = select(-127f, _e4790, (_e4790 > -127f));
let _e4794 = select(128f, _e4792, (_e4792 < 128f));
let _e4801 = select(0i, select(select(i32(_e4794), i32(-2147483648), (_e4794 < -2147483600f)), 2147483647i, (_e4794 > 2147483500f)), (_e4794 == _e4794));
let _e4805 = (_e4801 - select(0i, 1i, (_e4794 < f32(_e4801))));
let _e4806 = f32(_e4805);
let _e4810 = ((_e4788 - (_e4806 * 0.6933594f)) - (_e4806 * -2.1219444e-4f));
let _e4832 = select(((1f + (_e4696 * (1f + (_e4696 * (0.5f + (_e4696 * (0.16666667f + (_e4696 * (0.041666668f + (_e4696 * (0.008333334f + (_e4696 * (0.001388889f + (_e4696 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4691 + 127i)) << bitcast<u32>(23i)))), 1f, _e4475);
let _e4834 = (1f - (_e4594 * _e4832));
let _e4836 = (1f - _e4594);
let _e4842 = select(((1f + (_e4753 * (1f + (_e4753 * (0.5f + (_e4753 * (0.16666667f + (_e4753 * (0.041666668f + (_e4753 * (0.008333334f + (_e4753 * (0.001388889f + (_e4753 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4748 + 127i)) << bitcast<u32>(23i)))), 1f, _e4475);
let _e4844 = (1f - (_e4594 * _e4842));
let _e4851 = select(((1f + (_e4810 * (1f + (_e4810 * (0.5f + (_e4810 * (0.16666667f + (_e4810 * (0.041666668f + (_e4810 * (0.008333334f + (_e4810 * (0.001388889f + (_e4810 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4805 + 127i)) << bitcast<u32>(23i)))), 1f, _e4475);
let _e4853 = (1f - (_e4594 * _e4851));
let _e4866 = ((_e4634.member_2.x * select(1f, ((_e4836 * _e4832) / select(1e-9f, _e4834, (_e4834 > 1e-9f))), (_e4834 > 0f))) * _e4594);
let _e4867 = ((_e4634.member_2.y * select(1f, ((_e4836 * _e4842) / select(1e-9f, _e4844, (_e4844 > 1e-9f))), (_e4844 > 0f))) * _e4594);
let _e4868 = ((_e4634.member_2.z * select(1f, ((_e4836 * _e4851) / select(1e-9f, _e4853, (_e4853 > 1e-9f))), (_e4853 > 0f))) * _e4594);
let _e4876 = select(0i, select(select(i32(_e4634.member_8), i32(-2147483648), (_e4634.member_8 < -2147483600f)), 2147483647i, (_e4634.member_8 > 2147483500f)), (_e4634.member_8 == _e4634.member_8));
let _e4888 = ((_e4634.member_13.x + _e4634.member_13.y) + _e4634.member_13.z);
if ((((_e4591 & 8u) != 0u) && (_e4876 < 24i)) && (((_e4866 + _e4867) + _e4868) > _e4888)) {
if (_e4888 > 0f) {
if (_e4634.member_14 == 0i) {
phi_6710_ = 0i;
} else {
phi_6710_ = (_e4634.member_14 - (1i << bitcast<u32>(((bitcast<i32>((bitcast<u32>(f32(_e4634.member_14)) >> bitcast<u32>(23i))) - 127i) & 31i))));
}
let _e4932 = phi_6710_;
phi_6712_ = _e4932;
} else {
phi_6712_ = _e4634.member_14;
}
let _e4934 = phi_6712_;
let _e4956 = type_20(_e4634.member, _e4634.member_1, _e4634.member_2, _e4634.member_3, _e4634.member_4, _e4634.member_5, _e4634.member_6, _e4634.member_7, _e4634.member_8, _e4634.member_9, _e4634.member_10, _e4634.member_11, _e4634.member_12, _e4634.member_13, (_e4934 | (1i << bitcast<u32>((_e4876 & 31i)))), _e4634.member_15, _e4634.member_16, _e4634.member_17);
let _e4984 = type_20(_e4956.member, _e4956.member_1, _e4956.member_2, _e4956.member_3, _e4956.member_4, _e4956.member_5, _e4956.member_6, _e4956.member_7, _e4956.member_8, _e4956.member_9, _e4956.member_10, _e4956.member_11, vec3<f32>((_e4634.member_12.x + _e4634.member_13.x), (_e4634.member_12.y + _e4634.member_13.y), (_e4634.member_12.z + _e4634.member_13.z)), _e4956.member_13, _e4956.member_14, _e4956.member_15, _e4956.member_16, _e4956.member_17);
phi_6740_ = type_20(_e4984.member, _e4984.member_1, _e4984.member_2, _e4984.member_3, _e4984.member_4, _e4984.member_5, _e4984.member_6, _e4984.member_7, _e4984.member_8, _e4984.member_9, _e4984.member_10, _e4984.member_11, _e4984.member_12, vec3<f32>(_e4866, _e4867, _e4868), _e4984.member_14, _e4984.member_15, _e4984.member_16, _e4984.member_17);
} else {
phi_6740_ = type_20(_e4634.member, _e4634.member_1, _e4634.member_2, _e4634.member_3, _e4634.member_4, _e4634.member_5, _e4634.member_6, _e4634.member_7, _e4634.member_8, _e4634.member_9, _e4634.member_10, _e4634.member_11, vec3<f32>((_e4634.member_12.x + _e4866), (_e4634.member_12.y + _e4867), (_e4634.member_12.z + _e4868)), _e4634.member_13, _e4634.member_14, _e4634.member_15, _e4634.member_16, _e4634.member_17);
}
let _e5004 = phi_6740_;
phi_6741_ = _e5004;
} else {
phi_6741_ = _e4634;
}
let _e5006 = phi_6741_;
let _e5008 = (_e5006.member_8 + 1f);
let _e5026 = type_20(_e5006.member, _e5006.member_1, _e5006.member_2, _e5006.member_3, _e5006.member_4, _e5006.member_5, _e5006.member_6, _e5006.member_7, _e5008, _e5006.member_9, _e5006.member_10, _e5006.member_11, _e5006.member_12, _e5006.member_13, _e5006.member_14, _e5006.member_15, _e5006.member_16, _e5006.member_17);
let _e5030 = !(_e4650);
let _e5031 = (((_e110.member_2 == 0u) && (_e5008 >= 2f)) && _e5030);
if (_e4519 && _e5031) {
let _e5094 = (((_e5006.member_1.x * _e4129) + (_e5006.member_1.y * _e4130)) + (_e5006.member_1.z * _e4131));
let _e5098 = (_e5006.member_1.x - (_e4129 * _e5094));
let _e5099 = (_e5006.member_1.y - (_e4130 * _e5094));
let _e5100 = (_e5006.member_1.z - (_e4131 * _e5094));
let _e5105 = (((_e5098 * _e5098) + (_e5099 * _e5099)) + (_e5100 * _e5100));
let _e5108 = sqrt(select(0f, _e5105, (_e5105 > 0f)));
let _e5111 = (1f / select(1e-20f, _e5108, (_e5108 > 1e-20f)));
phi_6822_ = type_20(_e5026.member, vec3<f32>((_e5098 * _e5111), (_e5099 * _e5111), (_e5100 * _e5111)), _e5026.member_2, _e5026.member_3, _e5026.member_4, _e5026.member_5, _e5026.member_6, _e5026.member_7, _e5026.member_8, _e5026.member_9, _e5026.member_10, _e5026.member_11, _e5026.member_12, _e5026.member_13, _e5026.member_14, _e5026.member_15, _e5026.member_16, _e5026.member_17);
} else {
if _e4650 {
let _e5055 = (((_e4538 * _e4538) + (_e4539 * _e4539)) + (_e4540 * _e4540));
let _e5058 = sqrt(select(0f, _e5055, (_e5055 > 0f)));
let _e5061 = (1f / select(1e-20f, _e5058, (_e5058 > 1e-20f)));
phi_6821_ = type_20(_e5026.member, vec3<f32>((_e4538 * _e5061), (_e4539 * _e5061), (_e4540 * _e5061)), _e5026.member_2, _e5026.member_3, _e5026.member_4, _e5026.member_5, _e5026.member_6, _e5026.member_7, _e5026.member_8, _e5026.member_9, _e5026.member_10, _e5026.member_11, _e5026.member_12, _e5026.member_13, _e5026.member_14, _e5026.member_15, _e5026.member_16, _e5026.member_17);
} else {
phi_6821_ = type_20(_e5026.member, vec3<f32>((_e4541 * _e4554), (_e4542 * _e4554), (_e4543 * _e4554)), _e5026.member_2, _e5026.member_3, _e5026.member_4, _e5026.member_5, _e5026.member_6, _e5026.member_7, _e5026.member_8, _e5026.member_9, _e5026.member_10, _e5026.member_11, _e5026.member_12, _e5026.member_13, _e5026.member_14, _e5026.member_15, _e5026.member_16, _e5026.member_17);
}
let _e5085 = phi_6821_;
phi_6822_ = _e5085;
}
let _e5135 = phi_6822_;
if _e4519 {
phi_6840_ = _e5135;
} else {
let _e5137 = select((1f - _e4594), _e4594, _e4650);
phi_6840_ = type_20(_e5135.member, _e5135.member_1, vec3<f32>((_e5135.member_2.x * _e5137), (_e5135.member_2.y * _e5137), (_e5135.member_2.z * _e5137)), _e5135.member_3, _e5135.member_4, _e5135.member_5, _e5135.member_6, _e5135.member_7, _e5135.member_8, _e5135.member_9, _e5135.member_10, _e5135.member_11, _e5135.member_12, _e5135.member_13, _e5135.member_14, _e5135.member_15, _e5135.member_16, _e5135.member_17);
}
let _e5167 = phi_6840_;
let _e5185 = type_20(_e5167.member, _e5167.member_1, _e5167.member_2, _e5167.member_3, _e5167.member_4, 0f, _e5167.member_6, _e5167.member_7, _e5167.member_8, _e5167.member_9, _e5167.member_10, _e5167.member_11, _e5167.member_12, _e5167.member_13, _e5167.member_14, _e5167.member_15, _e5167.member_16, _e5167.member_17);
let _e5192 = global_1.member.member_18.member.member;
let _e5206 = ((((_e5192.member.member * _e5167.member.x) + (_e5192.member.member_1 * _e5167.member.y)) + (_e5192.member.member_2 * _e5167.member.z)) + _e5192.member_1);
let _e5215 = -((((_e5192.member.member * _e5167.member_1.x) + (_e5192.member.member_1 * _e5167.member_1.y)) + (_e5192.member.member_2 * _e5167.member_1.z)));
let _e5217 = (_e5215 > 1e-9f);
let _e5221 = ((_e5206 / select(1e-9f, _e5215, _e5217)) - 0.015625f);
let _e5224 = select(1e30f, select(0f, _e5221, (_e5221 > 0f)), ((_e5206 > 0f) && _e5217));
let _e5229 = global_1.member.member_18.member_1.member;
let _e5240 = ((((_e5229.member.member * _e5167.member.x) + (_e5229.member.member_1 * _e5167.member.y)) + (_e5229.member.member_2 * _e5167.member.z)) + _e5229.member_1);
let _e5246 = -((((_e5229.member.member * _e5167.member_1.x) + (_e5229.member.member_1 * _e5167.member_1.y)) + (_e5229.member.member_2 * _e5167.member_1.z)));
let _e5248 = (_e5246 > 1e-9f);
let _e5252 = ((_e5240 / select(1e-9f, _e5246, _e5248)) - 0.015625f);
let _e5255 = select(1e30f, select(0f, _e5252, (_e5252 > 0f)), ((_e5240 > 0f) && _e5248));
let _e5259 = (_e5255 < _e5224);
let _e5261 = select(select(-2i, -3i, _e5259), -1i, ((_e5224 >= 1e30f) && (_e5255 >= 1e30f)));
let _e5262 = select(_e5224, _e5255, _e5259);
let _e5280 = type_20(_e5185.member, _e5185.member_1, _e5185.member_2, _e5185.member_3, _e5185.member_4, _e5185.member_5, _e5185.member_6, _e5185.member_7, _e5185.member_8, _e5185.member_9, _e5185.member_10, _e5185.member_11, _e5185.member_12, _e5185.member_13, _e5185.member_14, 0i, _e5185.member_16, _e5185.member_17);
let _e5298 = type_20(_e5280.member, _e5280.member_1, _e5280.member_2, _e5280.member_3, _e5280.member_4, _e5280.member_5, _e5280.member_6, _e5280.member_7, _e5280.member_8, _e5280.member_9, _e5280.member_10, _e5280.member_11, _e5280.member_12, _e5280.member_13, _e5280.member_14, _e5280.member_15, _e5261, _e5280.member_17);
let _e5316 = type_20(_e5298.member, _e5298.member_1, _e5298.member_2, _e5298.member_3, _e5298.member_4, _e5298.member_5, _e5298.member_6, _e5298.member_7, _e5298.member_8, _e5298.member_9, _e5298.member_10, _e5298.member_11, _e5298.member_12, _e5298.member_13, _e5298.member_14, _e5298.member_15, _e5298.member_16, _e5262);
let _e5317 = (_e4519 || _e4650);
let _e5319 = local_19;
let _e5322 = ((_e4591 & 2u) != 0u);
if (_e5031 && !(_e5322)) {
if (_e5261 == -1i) {
phi_7267_ = type_20(_e5316.member, _e5316.member_1, _e5316.member_2, _e5316.member_3, _e5316.member_4, _e5316.member_5, 1f, _e5316.member_7, _e5316.member_8, _e5316.member_9, _e5316.member_10, _e5316.member_11, _e5316.member_12, _e5316.member_13, _e5316.member_14, _e5316.member_15, _e5316.member_16, _e5316.member_17);
} else {
let _e5408 = type_20(vec3<f32>((_e5167.member.x + (_e5167.member_1.x * _e5262)), (_e5167.member.y + (_e5167.member_1.y * _e5262)), (_e5167.member.z + (_e5167.member_1.z * _e5262))), _e5316.member_1, _e5316.member_2, _e5316.member_3, _e5316.member_4, _e5316.member_5, _e5316.member_6, _e5316.member_7, _e5316.member_8, _e5316.member_9, _e5316.member_10, _e5316.member_11, _e5316.member_12, _e5316.member_13, _e5316.member_14, _e5316.member_15, _e5316.member_16, _e5316.member_17);
let _e5427 = type_20(_e5408.member, _e5408.member_1, _e5408.member_2, _e5408.member_3, _e5408.member_4, (0f + _e5262), _e5408.member_6, _e5408.member_7, _e5408.member_8, _e5408.member_9, _e5408.member_10, _e5408.member_11, _e5408.member_12, _e5408.member_13, _e5408.member_14, _e5408.member_15, _e5408.member_16, _e5408.member_17);
let _e5446 = type_20(_e5427.member, _e5427.member_1, _e5427.member_2, _e5427.member_3, _e5427.member_4, _e5427.member_5, _e5427.member_6, _e5427.member_7, _e5427.member_8, _e5427.member_9, _e5427.member_10, _e5427.member_11, _e5427.member_12, _e5427.member_13, _e5427.member_14, _e5427.member_15, _e5427.member_16, (_e5262 - _e5262));
let _e5469 = type_20(_e5446.member, _e5446.member_1, _e5446.member_2, _e5446.member_3, _e5446.member_4, _e5446.member_5, _e5446.member_6, _e5446.member_7, _e5446.member_8, _e5446.member_9, (_e5167.member_10 + select(0f, _e5262, (_e5167.member_8 == 0f))), _e5446.member_11, _e5446.member_12, _e5446.member_13, _e5446.member_14, _e5446.member_15, _e5446.member_16, _e5446.member_17);
phi_7267_ = type_20(_e5469.member, _e5469.member_1, _e5469.member_2, _e5469.member_3, _e5469.member_4, _e5469.member_5, 3f, _e5469.member_7, _e5469.member_8, _e5469.member_9, _e5469.member_10, _e5469.member_11, _e5469.member_12, _e5469.member_13, _e5469.member_14, _e5469.member_15, _e5469.member_16, _e5469.member_17);
}
let _e5507 = phi_7267_;
phi_7290_ = _e5507;
} else {
let _e5330 = global_1.member.member_5;
if (((!(_e5031) && _e5030) && (_e5167.member_8 >= f32(bitcast<i32>(_e5330)))) && (select(_e5319, _e904.member_7, _e5317) != 16i)) {
phi_7289_ = type_20(_e5316.member, _e5316.member_1, _e5316.member_2, _e5316.member_3, _e5316.member_4, _e5316.member_5, 2f, _e5316.member_7, _e5316.member_8, _e5316.member_9, _e5316.member_10, _e5316.member_11, _e5316.member_12, _e5316.member_13, _e5316.member_14, _e5316.member_15, _e5316.member_16, _e5316.member_17);
} else {
if _e5322 {
phi_7288_ = type_20(_e5316.member, _e5316.member_1, _e5316.member_2, _e5316.member_3, _e5316.member_4, _e5316.member_5, 4f, _e5316.member_7, _e5316.member_8, _e5316.member_9, _e5316.member_10, _e5316.member_11, _e5316.member_12, _e5316.member_13, _e5316.member_14, _e5316.member_15, _e5316.member_16, _e5316.member_17);
} else {
phi_7288_ = _e5316;
}
let _e5356 = phi_7288_;
phi_7289_ = _e5356;
}
let _e5376 = phi_7289_;
phi_7290_ = _e5376;
}
let _e5509 = phi_7290_;
let _e5512 = local_20;
let _e5531 = type_20(_e5509.member, _e5509.member_1, _e5509.member_2, _e5509.member_3, _e5509.member_4, _e5509.member_5, _e5509.member_6, select(_e904.member_7, _e5512, !(_e5317)), _e5509.member_8, _e5509.member_9, _e5509.member_10, _e5509.member_11, _e5509.member_12, _e5509.member_13, _e5509.member_14, _e5509.member_15, _e5509.member_16, _e5509.member_17);
phi_7298_ = type_20(_e5531.member, _e5531.member_1, _e5531.member_2, _e5531.member_3, _e4132, _e5531.member_5, _e5531.member_6, _e5531.member_7, _e5531.member_8, _e5531.member_9, _e5531.member_10, _e5531.member_11, _e5531.member_12, _e5531.member_13, _e5531.member_14, _e5531.member_15, _e5531.member_16, _e5531.member_17);
}
let _e5551 = phi_7298_;
phi_7299_ = _e5551;
phi_7300_ = _e4158;
}
let _e5553 = phi_7299_;
let _e5555 = phi_7300_;
if (_e5555 && _e1114) {
let _e6064 = type_20(vec3<f32>((_e5553.member.x + (_e5553.member_1.x * _e5553.member_17)), (_e5553.member.y + (_e5553.member_1.y * _e5553.member_17)), (_e5553.member.z + (_e5553.member_1.z * _e5553.member_17))), _e5553.member_1, _e5553.member_2, _e5553.member_3, _e5553.member_4, _e5553.member_5, _e5553.member_6, _e5553.member_7, _e5553.member_8, _e5553.member_9, _e5553.member_10, _e5553.member_11, _e5553.member_12, _e5553.member_13, _e5553.member_14, _e5553.member_15, _e5553.member_16, _e5553.member_17);
let _e6084 = type_20(_e6064.member, _e6064.member_1, _e6064.member_2, _e6064.member_3, _e6064.member_4, (_e5553.member_5 + _e5553.member_17), _e6064.member_6, _e6064.member_7, _e6064.member_8, _e6064.member_9, _e6064.member_10, _e6064.member_11, _e6064.member_12, _e6064.member_13, _e6064.member_14, _e6064.member_15, _e6064.member_16, _e6064.member_17);
let _e6103 = type_20(_e6084.member, _e6084.member_1, _e6084.member_2, _e6084.member_3, _e6084.member_4, _e6084.member_5, _e6084.member_6, _e6084.member_7, _e6084.member_8, _e6084.member_9, _e6084.member_10, _e6084.member_11, _e6084.member_12, _e6084.member_13, _e6084.member_14, _e6084.member_15, _e6084.member_16, (_e5553.member_17 - _e5553.member_17));
let _e6126 = type_20(_e6103.member, _e6103.member_1, _e6103.member_2, _e6103.member_3, _e6103.member_4, _e6103.member_5, _e6103.member_6, _e6103.member_7, _e6103.member_8, _e6103.member_9, (_e5553.member_10 + select(0f, _e5553.member_17, (_e5553.member_8 == 0f))), _e6103.member_11, _e6103.member_12, _e6103.member_13, _e6103.member_14, _e6103.member_15, _e6103.member_16, _e6103.member_17);
if (_e904.member_7 != 16i) {
let _e6147 = type_20(_e6126.member, _e6126.member_1, _e6126.member_2, _e6126.member_3, _e6126.member_4, _e6126.member_5, _e6126.member_6, _e6126.member_7, _e6126.member_8, (_e5553.member_9 + _e5553.member_17), _e6126.member_10, _e6126.member_11, _e6126.member_12, _e6126.member_13, _e6126.member_14, _e6126.member_15, _e6126.member_16, _e6126.member_17);
let _e6148 = (_e904.member_7 * 4i);
let _e6149 = (_e6148 + 1i);
let _e6151 = (bitcast<i32>(_e103) - 1i);
let _e6153 = select(_e6151, _e6149, (_e6149 < _e6151));
let _e6159 = global_2.member[bitcast<u32>(select(0i, _e6153, (_e6153 > 0i)))];
let _e6161 = -((_e6159 * _e5553.member_17));
let _e6163 = select(-87f, _e6161, (_e6161 > -87f));
let _e6165 = select(88f, _e6163, (_e6163 < 88f));
let _e6167 = ((_e6165 * 1.442695f) + 0.5f);
let _e6169 = select(-127f, _e6167, (_e6167 > -127f));
let _e6171 = select(128f, _e6169, (_e6169 < 128f));
let _e6178 = select(0i, select(select(i32(_e6171), i32(-2147483648), (_e6171 < -2147483600f)), 2147483647i, (_e6171 > 2147483500f)), (_e6171 == _e6171));
let _e6182 = (_e6178 - select(0i, 1i, (_e6171 < f32(_e6178))));
let _e6183 = f32(_e6182);
let _e6187 = ((_e6165 - (_e6183 * 0.6933594f)) - (_e6183 * -2.1219444e-4f));
let _e6208 = (_e6148 + 2i);
let _e6210 = select(_e6151, _e6208, (_e6208 < _e6151));
let _e6216 = global_2.member[bitcast<u32>(select(0i, _e6210, (_e6210 > 0i)))];
let _e6218 = -((_e6216 * _e5553.member_17));
let _e6220 = select(-87f, _e6218, (_e6218 > -87f));
let _e6222 = select(88f, _e6220, (_e6220 < 88f));
let _e6224 = ((_e6222 * 1.442695f) + 0.5f);
let _e6226 = select(-127f, _e6224, (_e6224 > -127f));
let _e6228 = select(128f, _e6226, (_e6226 < 128f));
let _e6235 = select(0i, select(select(i32(_e6228), i32(-2147483648), (_e6228 < -2147483600f)), 2147483647i, (_e6228 > 2147483500f)), (_e6228 == _e6228));
let _e6239 = (_e6235 - select(0i, 1i, (_e6228 < f32(_e6235))));
let _e6240 = f32(_e6239);
let _e6244 = ((_e6222 - (_e6240 * 0.6933594f)) - (_e6240 * -2.1219444e-4f));
let _e6265 = (_e6148 + 3i);
let _e6267 = select(_e6151, _e6265, (_e6265 < _e6151));
let _e6273 = global_2.member[bitcast<u32>(select(0i, _e6267, (_e6267 > 0i)))];
let _e6275 = -((_e6273 * _e5553.member_17));
let _e6277 = select(-87f, _e6275, (_e6275 > -87f));
let _e6279 = select(88f, _e6277, (_e6277 < 88f));
let _e6281 = ((_e6279 * 1.442695f) + 0.5f);
let _e6283 = select(-127f, _e6281, (_e6281 > -127f));
let _e6285 = select(128f, _e6283, (_e6283 < 128f));
let _e6292 = select(0i, select(select(i32(_e6285), i32(-2147483648), (_e6285 < -2147483600f)), 2147483647i, (_e6285 > 2147483500f)), (_e6285 == _e6285));
let _e6296 = (_e6292 - select(0i, 1i, (_e6285 < f32(_e6292))));
let _e6297 = f32(_e6296);
let _e6301 = ((_e6279 - (_e6297 * 0.6933594f)) - (_e6297 * -2.1219444e-4f));
phi_7590_ = type_20(_e6147.member, _e6147.member_1, vec3<f32>((_e5553.member_2.x * ((1f + (_e6187 * (1f + (_e6187 * (0.5f + (_e6187 * (0.16666667f + (_e6187 * (0.041666668f + (_e6187 * (0.008333334f + (_e6187 * (0.001388889f + (_e6187 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6182 + 127i)) << bitcast<u32>(23i))))), (_e5553.member_2.y * ((1f + (_e6244 * (1f + (_e6244 * (0.5f + (_e6244 * (0.16666667f + (_e6244 * (0.041666668f + (_e6244 * (0.008333334f + (_e6244 * (0.001388889f + (_e6244 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6239 + 127i)) << bitcast<u32>(23i))))), (_e5553.member_2.z * ((1f + (_e6301 * (1f + (_e6301 * (0.5f + (_e6301 * (0.16666667f + (_e6301 * (0.041666668f + (_e6301 * (0.008333334f + (_e6301 * (0.001388889f + (_e6301 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6296 + 127i)) << bitcast<u32>(23i)))))), _e6147.member_3, _e6147.member_4, _e6147.member_5, _e6147.member_6, _e6147.member_7, _e6147.member_8, _e6147.member_9, _e6147.member_10, _e6147.member_11, _e6147.member_12, _e6147.member_13, _e6147.member_14, _e6147.member_15, _e6147.member_16, _e6147.member_17);
} else {
phi_7590_ = _e6126;
}
let _e6351 = phi_7590_;
phi_8184_ = type_20(_e6351.member, _e6351.member_1, _e6351.member_2, _e6351.member_3, _e6351.member_4, _e6351.member_5, 3f, _e6351.member_7, _e6351.member_8, _e6351.member_9, _e6351.member_10, _e6351.member_11, _e6351.member_12, _e6351.member_13, _e6351.member_14, _e6351.member_15, _e6351.member_16, _e6351.member_17);
} else {
if _e5555 {
let _e5591 = type_20(vec3<f32>((_e5553.member.x + (_e5553.member_1.x * _e1115)), (_e5553.member.y + (_e5553.member_1.y * _e1115)), (_e5553.member.z + (_e5553.member_1.z * _e1115))), _e5553.member_1, _e5553.member_2, _e5553.member_3, _e5553.member_4, _e5553.member_5, _e5553.member_6, _e5553.member_7, _e5553.member_8, _e5553.member_9, _e5553.member_10, _e5553.member_11, _e5553.member_12, _e5553.member_13, _e5553.member_14, _e5553.member_15, _e5553.member_16, _e5553.member_17);
let _e5611 = type_20(_e5591.member, _e5591.member_1, _e5591.member_2, _e5591.member_3, _e5591.member_4, (_e5553.member_5 + _e1115), _e5591.member_6, _e5591.member_7, _e5591.member_8, _e5591.member_9, _e5591.member_10, _e5591.member_11, _e5591.member_12, _e5591.member_13, _e5591.member_14, _e5591.member_15, _e5591.member_16, _e5591.member_17);
let _e5631 = type_20(_e5611.member, _e5611.member_1, _e5611.member_2, _e5611.member_3, _e5611.member_4, _e5611.member_5, _e5611.member_6, _e5611.member_7, _e5611.member_8, _e5611.member_9, _e5611.member_10, _e5611.member_11, _e5611.member_12, _e5611.member_13, _e5611.member_14, _e5611.member_15, _e5611.member_16, (_e5553.member_17 - _e1115));
let _e5654 = type_20(_e5631.member, _e5631.member_1, _e5631.member_2, _e5631.member_3, _e5631.member_4, _e5631.member_5, _e5631.member_6, _e5631.member_7, _e5631.member_8, _e5631.member_9, (_e5553.member_10 + select(0f, _e1115, (_e5553.member_8 == 0f))), _e5631.member_11, _e5631.member_12, _e5631.member_13, _e5631.member_14, _e5631.member_15, _e5631.member_16, _e5631.member_17);
if (_e904.member_7 != 16i) {
let _e5675 = type_20(_e5654.member, _e5654.member_1, _e5654.member_2, _e5654.member_3, _e5654.member_4, _e5654.member_5, _e5654.member_6, _e5654.member_7, _e5654.member_8, (_e5553.member_9 + _e1115), _e5654.member_10, _e5654.member_11, _e5654.member_12, _e5654.member_13, _e5654.member_14, _e5654.member_15, _e5654.member_16, _e5654.member_17);
let _e5676 = (_e904.member_7 * 4i);
let _e5677 = (_e5676 + 1i);
let _e5679 = (bitcast<i32>(_e103) - 1i);
let _e5681 = select(_e5679, _e5677, (_e5677 < _e5679));
let _e5687 = global_2.member[bitcast<u32>(select(0i, _e5681, (_e5681 > 0i)))];
let _e5689 = -((_e5687 * _e1115));
let _e5691 = select(-87f, _e5689, (_e5689 > -87f));
let _e5693 = select(88f, _e5691, (_e5691 < 88f));
let _e5695 = ((_e5693 * 1.442695f) + 0.5f);
let _e5697 = select(-127f, _e5695, (_e5695 > -127f));
let _e5699 = select(128f, _e5697, (_e5697 < 128f));
let _e5706 = select(0i, select(select(i32(_e5699), i32(-2147483648), (_e5699 < -2147483600f)), 2147483647i, (_e5699 > 2147483500f)), (_e5699 == _e5699));
let _e5710 = (_e5706 - select(0i, 1i, (_e5699 < f32(_e5706))));
let _e5711 = f32(_e5710);
let _e5715 = ((_e5693 - (_e5711 * 0.6933594f)) - (_e5711 * -2.1219444e-4f));
let _e5736 = (_e5676 + 2i);
let _e5738 = select(_e5679, _e5736, (_e5736 < _e5679));
let _e5744 = global_2.member[bitcast<u32>(select(0i, _e5738, (_e5738 > 0i)))];
let _e5746 = -((_e5744 * _e1115));
let _e5748 = select(-87f, _e5746, (_e5746 > -87f));
let _e5750 = select(88f, _e5748, (_e5748 < 88f));
let _e5752 = ((_e5750 * 1.442695f) + 0.5f);
let _e5754 = select(-127f, _e5752, (_e5752 > -127f));
let _e5756 = select(128f, _e5754, (_e5754 < 128f));
let _e5763 = select(0i, select(select(i32(_e5756), i32(-2147483648), (_e5756 < -2147483600f)), 2147483647i, (_e5756 > 2147483500f)), (_e5756 == _e5756));
let _e5767 = (_e5763 - select(0i, 1i, (_e5756 < f32(_e5763))));
let _e5768 = f32(_e5767);
let _e5772 = ((_e5750 - (_e5768 * 0.6933594f)) - (_e5768 * -2.1219444e-4f));
let _e5793 = (_e5676 + 3i);
let _e5795 = select(_e5679, _e5793, (_e5793 < _e5679));
let _e5801 = global_2.member[bitcast<u32>(select(0i, _e5795, (_e5795 > 0i)))];
let _e5803 = -((_e5801 * _e1115));
let _e5805 = select(-87f, _e5803, (_e5803 > -87f));
let _e5807 = select(88f, _e5805, (_e5805 < 88f));
let _e5809 = ((_e5807 * 1.442695f) + 0.5f);
let _e5811 = select(-127f, _e5809, (_e5809 > -127f));
let _e5813 = select(128f, _e5811, (_e5811 < 128f));
let _e5820 = select(0i, select(select(i32(_e5813), i32(-2147483648), (_e5813 < -2147483600f)), 2147483647i, (_e5813 > 2147483500f)), (_e5813 == _e5813));
let _e5824 = (_e5820 - select(0i, 1i, (_e5813 < f32(_e5820))));
let _e5825 = f32(_e5824);
let _e5829 = ((_e5807 - (_e5825 * 0.6933594f)) - (_e5825 * -2.1219444e-4f));
phi_7879_ = type_20(_e5675.member, _e5675.member_1, vec3<f32>((_e5553.member_2.x * ((1f + (_e5715 * (1f + (_e5715 * (0.5f + (_e5715 * (0.16666667f + (_e5715 * (0.041666668f + (_e5715 * (0.008333334f + (_e5715 * (0.001388889f + (_e5715 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5710 + 127i)) << bitcast<u32>(23i))))), (_e5553.member_2.y * ((1f + (_e5772 * (1f + (_e5772 * (0.5f + (_e5772 * (0.16666667f + (_e5772 * (0.041666668f + (_e5772 * (0.008333334f + (_e5772 * (0.001388889f + (_e5772 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5767 + 127i)) << bitcast<u32>(23i))))), (_e5553.member_2.z * ((1f + (_e5829 * (1f + (_e5829 * (0.5f + (_e5829 * (0.16666667f + (_e5829 * (0.041666668f + (_e5829 * (0.008333334f + (_e5829 * (0.001388889f + (_e5829 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5824 + 127i)) << bitcast<u32>(23i)))))), _e5675.member_3, _e5675.member_4, _e5675.member_5, _e5675.member_6, _e5675.member_7, _e5675.member_8, _e5675.member_9, _e5675.member_10, _e5675.member_11, _e5675.member_12, _e5675.member_13, _e5675.member_14, _e5675.member_15, _e5675.member_16, _e5675.member_17);
} else {
phi_7879_ = _e5654;
}
let _e5879 = phi_7879_;
let _e5882 = local_21;
if (((_e965 <= 0f) && (_e5882 == 16i)) && (_e904.member_7 == 16i)) {
if (_e5879.member_16 == -1i) {
phi_8181_ = type_20(_e5879.member, _e5879.member_1, _e5879.member_2, _e5879.member_3, _e5879.member_4, _e5879.member_5, 1f, _e5879.member_7, _e5879.member_8, _e5879.member_9, _e5879.member_10, _e5879.member_11, _e5879.member_12, _e5879.member_13, _e5879.member_14, _e5879.member_15, _e5879.member_16, _e5879.member_17);
} else {
let _e5924 = type_20(vec3<f32>((_e5879.member.x + (_e5879.member_1.x * _e5879.member_17)), (_e5879.member.y + (_e5879.member_1.y * _e5879.member_17)), (_e5879.member.z + (_e5879.member_1.z * _e5879.member_17))), _e5879.member_1, _e5879.member_2, _e5879.member_3, _e5879.member_4, _e5879.member_5, _e5879.member_6, _e5879.member_7, _e5879.member_8, _e5879.member_9, _e5879.member_10, _e5879.member_11, _e5879.member_12, _e5879.member_13, _e5879.member_14, _e5879.member_15, _e5879.member_16, _e5879.member_17);
let _e5944 = type_20(_e5924.member, _e5924.member_1, _e5924.member_2, _e5924.member_3, _e5924.member_4, (_e5879.member_5 + _e5879.member_17), _e5924.member_6, _e5924.member_7, _e5924.member_8, _e5924.member_9, _e5924.member_10, _e5924.member_11, _e5924.member_12, _e5924.member_13, _e5924.member_14, _e5924.member_15, _e5924.member_16, _e5924.member_17);
let _e5963 = type_20(_e5944.member, _e5944.member_1, _e5944.member_2, _e5944.member_3, _e5944.member_4, _e5944.member_5, _e5944.member_6, _e5944.member_7, _e5944.member_8, _e5944.member_9, _e5944.member_10, _e5944.member_11, _e5944.member_12, _e5944.member_13, _e5944.member_14, _e5944.member_15, _e5944.member_16, (_e5879.member_17 - _e5879.member_17));
let _e5986 = type_20(_e5963.member, _e5963.member_1, _e5963.member_2, _e5963.member_3, _e5963.member_4, _e5963.member_5, _e5963.member_6, _e5963.member_7, _e5963.member_8, _e5963.member_9, (_e5879.member_10 + select(0f, _e5879.member_17, (_e5879.member_8 == 0f))), _e5963.member_11, _e5963.member_12, _e5963.member_13, _e5963.member_14, _e5963.member_15, _e5963.member_16, _e5963.member_17);
phi_8181_ = type_20(_e5986.member, _e5986.member_1, _e5986.member_2, _e5986.member_3, _e5986.member_4, _e5986.member_5, 3f, _e5986.member_7, _e5986.member_8, _e5986.member_9, _e5986.member_10, _e5986.member_11, _e5986.member_12, _e5986.member_13, _e5986.member_14, _e5986.member_15, _e5986.member_16, _e5986.member_17);
}
let _e6024 = phi_8181_;
phi_8182_ = _e6024;
} else {
phi_8182_ = _e5879;
}
let _e6026 = phi_8182_;
phi_8183_ = _e6026;
} else {
phi_8183_ = _e5553;
}
let _e6028 = phi_8183_;
phi_8184_ = _e6028;
}
let _e6371 = phi_8184_;
phi_1334_ = _e6371;
phi_1337_ = (_e906 + 1i);
} else {
phi_1334_ = type_20();
phi_1337_ = i32();
}
let _e6373 = phi_1334_;
let _e6375 = phi_1337_;
continue;
continuing {
phi_1333_ = _e6373;
phi_1336_ = _e6375;
break if !(_e910);
}
}
let _e6378 = local_22;
let _e6382 = local_23;
let _e6386 = local_24;
let _e6390 = local_25;
let _e6394 = local_26;
let _e6398 = local_27;
let _e6402 = local_28;
let _e6406 = local_29;
let _e6410 = local_30;
let _e6414 = local_31;
let _e6418 = local_32;
let _e6422 = local_33;
let _e6426 = local_34;
let _e6430 = local_35;
let _e6434 = local_36;
let _e6438 = local_37;
let _e6441 = local_38;
let _e6445 = local_39;
let _e6448 = local_40;
let _e6451 = local_41;
let _e6454 = local_42;
let _e6457 = local_43;
let _e6461 = local_44;
let _e6465 = local_45;
let _e6469 = local_46;
let _e6473 = local_47;
let _e6477 = local_48;
let _e6481 = local_49;
let _e6485 = local_50;
let _e6489 = local_51;
let _e6493 = local_52;
global_3.member[_e119] = _e6378.member.x;
global_3.member[_e131] = _e6382.member.y;
global_3.member[_e142] = _e6386.member.z;
global_3.member[_e153] = _e6390.member_1.x;
global_3.member[_e164] = _e6394.member_1.y;
global_3.member[_e175] = _e6398.member_1.z;
global_3.member[_e186] = _e6402.member_2.x;
global_3.member[_e197] = _e6406.member_2.y;
global_3.member[_e208] = _e6410.member_2.z;
global_3.member[_e219] = _e6414.member_3.x;
global_3.member[_e230] = _e6418.member_3.y;
global_3.member[_e241] = _e6422.member_3.z;
global_3.member[_e252] = _e6426.member_4.x;
global_3.member[_e263] = _e6430.member_4.y;
global_3.member[_e274] = _e6434.member_4.z;
global_3.member[_e285] = _e6438.member_5;
let _e6530 = local_53;
global_3.member[_e296] = _e6530;
global_3.member[_e307] = f32(_e6441.member_7);
global_3.member[_e318] = _e6445.member_8;
global_3.member[_e329] = _e6448.member_9;
global_3.member[_e340] = _e6451.member_10;
global_3.member[_e351] = _e6454.member_11;
global_3.member[_e362] = _e6457.member_12.x;
global_3.member[_e373] = _e6461.member_12.y;
global_3.member[_e384] = _e6465.member_12.z;
global_3.member[_e395] = _e6469.member_13.x;
global_3.member[_e406] = _e6473.member_13.y;
global_3.member[_e417] = _e6477.member_13.z;
global_3.member[_e428] = f32(_e6481.member_14);
global_3.member[_e439] = f32(_e6485.member_15);
global_3.member[_e450] = f32(_e6489.member_16);
global_3.member[_e461] = _e6493.member_17;
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
