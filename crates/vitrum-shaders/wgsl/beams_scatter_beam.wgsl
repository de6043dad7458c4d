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
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
}
struct type_19 {
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
struct type_23 {
member: i32,
member_1: i32,
}
struct type_26 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(5)
var<storage> global_2: type_13;
@group(0) @binding(1)
var<storage> global_3: type_13;
@group(0) @binding(2)
var<storage> global_4: type_13;
@group(0) @binding(3)
var<storage> global_5: type_13;
@group(0) @binding(4)
var<storage> global_6: type_13;
@group(0) @binding(6)
var<storage> global_7: type_13;
@group(0) @binding(7)
var<storage, read_write> global_8: type_26;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: i32;
var local_17: i32;
var local_18: i32;
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var local_32: i32;
var local_33: i32;
var local_34: i32;
var local_35: i32;
var local_36: i32;
var local_37: i32;
var local_38: i32;
var local_39: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var local_45: i32;
var local_46: i32;
var local_47: i32;
var local_48: i32;
var local_49: i32;
var local_50: i32;
var local_51: i32;
var local_52: i32;
var local_53: i32;
var local_54: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var local_59: i32;
var local_60: i32;
var local_61: i32;
var local_62: i32;
var local_63: i32;
var local_64: i32;
var local_65: i32;
var local_66: i32;
var local_67: i32;
var local_68: i32;
var local_69: i32;
var local_70: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var local_75: i32;
var local_76: i32;
var local_77: i32;
var local_78: i32;
var local_79: i32;
var local_80: i32;
var local_81: i32;
var local_82: i32;
var local_83: i32;
var local_84: i32;
var local_85: i32;
var local_86: i32;
var local_87: i32;
var local_88: i32;
var local_89: i32;
var local_90: i32;
var local_91: i32;
var local_92: i32;
var local_93: i32;
var local_94: i32;
var local_95: i32;
var local_96: i32;
var local_97: i32;
var local_98: i32;
var local_99: i32;
var local_100: i32;
var local_101: i32;
var local_102: i32;
var local_103: i32;
var local_104: f32;
var local_105: i32;
var local_106: i32;
var local_107: i32;
var local_108: i32;
var local_109: i32;
var local_110: i32;
var local_111: i32;
var local_112: i32;
var local_113: i32;
var local_114: i32;
var local_115: i32;
var local_116: i32;
var local_117: i32;
var local_118: i32;
var local_119: i32;
var local_120: i32;
var local_121: i32;
var local_122: f32;
var local_123: i32;
var local_124: i32;
var local_125: i32;
var local_126: i32;
var local_127: i32;
var local_128: i32;
var local_129: i32;
var local_130: i32;
var local_131: i32;
var local_132: f32;
var local_133: i32;
var local_134: i32;
var local_135: i32;
var local_136: i32;
var local_137: i32;
var local_138: i32;
var local_139: i32;
var local_140: i32;
var local_141: i32;
var local_142: f32;
var local_143: i32;
var local_144: i32;
var local_145: i32;
var local_146: i32;
var local_147: i32;
var local_148: i32;
var local_149: i32;
var local_150: i32;
var local_151: i32;
var local_152: i32;
var local_153: i32;
var local_154: i32;
var local_155: i32;
var local_156: i32;
var local_157: i32;
var local_158: i32;
var local_159: i32;
var local_160: i32;
var local_161: i32;
var local_162: i32;
var local_163: i32;
var local_164: i32;
var local_165: i32;
var local_166: i32;
var local_167: i32;
var local_168: i32;
var local_169: i32;
var local_170: i32;
var local_171: i32;
var local_172: i32;
var local_173: i32;
var local_174: i32;
var local_175: i32;
var local_176: i32;
var local_177: i32;
var local_178: f32;
var local_179: i32;
var local_180: i32;
var local_181: i32;
var local_182: i32;
var local_183: i32;
var local_184: i32;
var local_185: i32;
var local_186: i32;
var local_187: i32;
var local_188: i32;
var local_189: i32;
var local_190: i32;
var local_191: i32;
var local_192: i32;
var local_193: i32;
var local_194: i32;
var local_195: i32;
var local_196: f32;
var local_197: i32;
var local_198: i32;
var local_199: i32;
var local_200: i32;
var local_201: i32;
var local_202: i32;
var local_203: i32;
var local_204: i32;
var local_205: i32;
var local_206: f32;
var local_207: i32;
var local_208: i32;
var local_209: i32;
var local_210: i32;
var local_211: i32;
var local_212: i32;
var local_213: i32;
var local_214: i32;
var local_215: i32;
var local_216: i32;
var local_217: i32;
var local_218: i32;
var local_219: i32;
var local_220: i32;
var local_221: i32;
var local_222: i32;
var local_223: i32;
var local_224: i32;
var local_225: i32;
var local_226: i32;
var local_227: i32;
var phi_702_: bool;
var phi_703_: bool;
var phi_704_: bool;
var phi_1084_: type_23;
var phi_1796_: f32;
var phi_1799_: u32;
var phi_1797_: f32;
var phi_1800_: u32;
var local_228: u32;
var phi_1829_: f32;
var phi_1832_: u32;
var phi_1830_: f32;
var phi_1833_: u32;
var phi_1844_: u32;
var phi_1899_: f32;
var phi_1902_: u32;
var phi_1900_: f32;
var phi_1903_: u32;
var local_229: u32;
var phi_1932_: f32;
var phi_1935_: u32;
var phi_1933_: f32;
var phi_1936_: u32;
var phi_1947_: u32;
var phi_1948_: u32;
var phi_2003_: f32;
var phi_2006_: u32;
var phi_2004_: f32;
var phi_2007_: u32;
var local_230: u32;
var phi_2036_: f32;
var phi_2039_: u32;
var phi_2037_: f32;
var phi_2040_: u32;
var phi_2051_: u32;
var phi_2052_: u32;
var phi_2098_: type_23;
var phi_2173_: i32;
var phi_2211_: i32;
var phi_2365_: i32;
var phi_2470_: type_23;
var phi_2897_: f32;
var phi_3003_: f32;
var phi_3130_: f32;
var phi_3278_: i32;
var phi_3291_: i32;
var phi_3305_: i32;
var phi_3740_: type_23;
var phi_3973_: u32;
var phi_4003_: u32;
var phi_4033_: u32;
var phi_2366_: i32;
var phi_2212_: i32;
var phi_4082_: i32;
var phi_4236_: i32;
var phi_4341_: type_23;
var phi_4768_: f32;
var phi_4874_: f32;
var phi_5001_: f32;
var phi_5149_: i32;
var phi_5162_: i32;
var phi_5176_: i32;
var phi_5637_: type_23;
var phi_5715_: i32;
var phi_5726_: i32;
var phi_5754_: type_23;
var phi_5803_: u32;
var phi_5804_: u32;
var phi_5805_: u32;
var phi_6466_: i32;
var phi_6477_: i32;
var phi_6505_: type_23;
var phi_6554_: u32;
var phi_6555_: u32;
var phi_6556_: u32;
var phi_7217_: i32;
var phi_7228_: i32;
var phi_7256_: type_23;
var phi_7305_: u32;
var phi_7306_: u32;
var phi_7307_: u32;
var phi_7968_: i32;
var phi_7979_: i32;
var phi_8007_: type_23;
var phi_8056_: u32;
var phi_8057_: u32;
var phi_8058_: u32;
var phi_8728_: type_23;
var phi_8961_: u32;
var phi_8991_: u32;
var phi_9021_: u32;
var phi_4237_: i32;
var phi_4083_: i32;
var phi_9066_: i32;
var phi_9220_: i32;
var phi_9325_: type_23;
var phi_9752_: f32;
var phi_9858_: f32;
var phi_9985_: f32;
var phi_10133_: i32;
var phi_10146_: i32;
var phi_10160_: i32;
var phi_10619_: type_23;
var phi_10697_: i32;
var phi_10708_: i32;
var phi_10736_: type_23;
var phi_10785_: u32;
var phi_10786_: u32;
var phi_10787_: u32;
var phi_11448_: i32;
var phi_11459_: i32;
var phi_11487_: type_23;
var phi_11536_: u32;
var phi_11537_: u32;
var phi_11538_: u32;
var phi_12199_: i32;
var phi_12210_: i32;
var phi_12238_: type_23;
var phi_12287_: u32;
var phi_12288_: u32;
var phi_12289_: u32;
var phi_12950_: i32;
var phi_12961_: i32;
var phi_12989_: type_23;
var phi_13038_: u32;
var phi_13039_: u32;
var phi_13040_: u32;
var phi_13719_: type_23;
var phi_13797_: i32;
var phi_13808_: i32;
var phi_13836_: type_23;
var phi_13885_: u32;
var phi_13886_: u32;
var phi_13887_: u32;
var phi_14548_: i32;
var phi_14559_: i32;
var phi_14587_: type_23;
var phi_14636_: u32;
var phi_14637_: u32;
var phi_14638_: u32;
var phi_15299_: i32;
var phi_15310_: i32;
var phi_15338_: type_23;
var phi_15387_: u32;
var phi_15388_: u32;
var phi_15389_: u32;
var phi_16050_: i32;
var phi_16061_: i32;
var phi_16089_: type_23;
var phi_16138_: u32;
var phi_16139_: u32;
var phi_16140_: u32;
var phi_16819_: type_23;
var phi_16897_: i32;
var phi_16908_: i32;
var phi_16936_: type_23;
var phi_16985_: u32;
var phi_16986_: u32;
var phi_16987_: u32;
var phi_17648_: i32;
var phi_17659_: i32;
var phi_17687_: type_23;
var phi_17736_: u32;
var phi_17737_: u32;
var phi_17738_: u32;
var phi_18399_: i32;
var phi_18410_: i32;
var phi_18438_: type_23;
var phi_18487_: u32;
var phi_18488_: u32;
var phi_18489_: u32;
var phi_19150_: i32;
var phi_19161_: i32;
var phi_19189_: type_23;
var phi_19238_: u32;
var phi_19239_: u32;
var phi_19240_: u32;
var phi_19910_: type_23;
var phi_20143_: u32;
var phi_20173_: u32;
var phi_20203_: u32;
var phi_9221_: i32;
var phi_9067_: i32;
var phi_20269_: type_23;
var phi_20344_: i32;
var phi_20348_: type_23;
var phi_20351_: i32;
var phi_20502_: type_23;
var phi_20505_: i32;
var phi_20635_: type_23;
var phi_20684_: u32;
var phi_20685_: u32;
var phi_20686_: u32;
var phi_20812_: i32;
var phi_20823_: i32;
var phi_21246_: f32;
var phi_21352_: f32;
var phi_21479_: f32;
var phi_21627_: i32;
var phi_21640_: i32;
var phi_21654_: i32;
var phi_22110_: type_23;
var phi_22307_: u32;
var phi_22308_: u32;
var phi_22309_: u32;
var phi_22343_: u32;
var phi_22373_: u32;
var phi_22403_: u32;
var phi_22440_: type_23;
var phi_20503_: type_23;
var phi_20506_: i32;
var phi_20349_: type_23;
var phi_20352_: i32;
var local_231: type_23;
var local_232: type_23;
var phi_22457_: i32;
var phi_22492_: i32;
var phi_22646_: i32;
var phi_22751_: type_23;
var phi_23178_: f32;
var phi_23284_: f32;
var phi_23411_: f32;
var phi_23559_: i32;
var phi_23572_: i32;
var phi_23586_: i32;
var phi_24021_: type_23;
var phi_24254_: u32;
var phi_24284_: u32;
var phi_24314_: u32;
var phi_22647_: i32;
var phi_22493_: i32;
var phi_24363_: i32;
var phi_24517_: i32;
var phi_24622_: type_23;
var phi_25049_: f32;
var phi_25155_: f32;
var phi_25282_: f32;
var phi_25430_: i32;
var phi_25443_: i32;
var phi_25457_: i32;
var phi_25918_: type_23;
var phi_25996_: i32;
var phi_26007_: i32;
var phi_26035_: type_23;
var phi_26084_: u32;
var phi_26085_: u32;
var phi_26086_: u32;
var phi_26747_: i32;
var phi_26758_: i32;
var phi_26786_: type_23;
var phi_26835_: u32;
var phi_26836_: u32;
var phi_26837_: u32;
var phi_27498_: i32;
var phi_27509_: i32;
var phi_27537_: type_23;
var phi_27586_: u32;
var phi_27587_: u32;
var phi_27588_: u32;
var phi_28249_: i32;
var phi_28260_: i32;
var phi_28288_: type_23;
var phi_28337_: u32;
var phi_28338_: u32;
var phi_28339_: u32;
var phi_29009_: type_23;
var phi_29242_: u32;
var phi_29272_: u32;
var phi_29302_: u32;
var phi_24518_: i32;
var phi_24364_: i32;
var phi_29347_: i32;
var phi_29501_: i32;
var phi_29606_: type_23;
var phi_30033_: f32;
var phi_30139_: f32;
var phi_30266_: f32;
var phi_30414_: i32;
var phi_30427_: i32;
var phi_30441_: i32;
var phi_30900_: type_23;
var phi_30978_: i32;
var phi_30989_: i32;
var phi_31017_: type_23;
var phi_31066_: u32;
var phi_31067_: u32;
var phi_31068_: u32;
var phi_31729_: i32;
var phi_31740_: i32;
var phi_31768_: type_23;
var phi_31817_: u32;
var phi_31818_: u32;
var phi_31819_: u32;
var phi_32480_: i32;
var phi_32491_: i32;
var phi_32519_: type_23;
var phi_32568_: u32;
var phi_32569_: u32;
var phi_32570_: u32;
var phi_33231_: i32;
var phi_33242_: i32;
var phi_33270_: type_23;
var phi_33319_: u32;
var phi_33320_: u32;
var phi_33321_: u32;
var phi_34000_: type_23;
var phi_34078_: i32;
var phi_34089_: i32;
var phi_34117_: type_23;
var phi_34166_: u32;
var phi_34167_: u32;
var phi_34168_: u32;
var phi_34829_: i32;
var phi_34840_: i32;
var phi_34868_: type_23;
var phi_34917_: u32;
var phi_34918_: u32;
var phi_34919_: u32;
var phi_35580_: i32;
var phi_35591_: i32;
var phi_35619_: type_23;
var phi_35668_: u32;
var phi_35669_: u32;
var phi_35670_: u32;
var phi_36331_: i32;
var phi_36342_: i32;
var phi_36370_: type_23;
var phi_36419_: u32;
var phi_36420_: u32;
var phi_36421_: u32;
var phi_37100_: type_23;
var phi_37178_: i32;
var phi_37189_: i32;
var phi_37217_: type_23;
var phi_37266_: u32;
var phi_37267_: u32;
var phi_37268_: u32;
var phi_37929_: i32;
var phi_37940_: i32;
var phi_37968_: type_23;
var phi_38017_: u32;
var phi_38018_: u32;
var phi_38019_: u32;
var phi_38680_: i32;
var phi_38691_: i32;
var phi_38719_: type_23;
var phi_38768_: u32;
var phi_38769_: u32;
var phi_38770_: u32;
var phi_39431_: i32;
var phi_39442_: i32;
var phi_39470_: type_23;
var phi_39519_: u32;
var phi_39520_: u32;
var phi_39521_: u32;
var phi_40191_: type_23;
var phi_40424_: u32;
var phi_40454_: u32;
var phi_40484_: u32;
var phi_29502_: i32;
var phi_29348_: i32;
var phi_40551_: type_23;
var phi_40626_: i32;
var phi_40664_: i32;
var phi_40818_: i32;
var phi_40923_: type_23;
var phi_41350_: f32;
var phi_41595_: type_23;
var phi_41828_: u32;
var phi_41858_: u32;
var phi_41888_: u32;
var phi_40819_: i32;
var phi_40665_: i32;
var phi_41937_: i32;
var phi_42091_: i32;
var phi_42196_: type_23;
var phi_42623_: f32;
var phi_42894_: type_23;
var phi_42972_: i32;
var phi_42983_: i32;
var phi_43011_: type_23;
var phi_43060_: u32;
var phi_43061_: u32;
var phi_43062_: u32;
var phi_43723_: i32;
var phi_43734_: i32;
var phi_43762_: type_23;
var phi_43811_: u32;
var phi_43812_: u32;
var phi_43813_: u32;
var phi_44474_: i32;
var phi_44485_: i32;
var phi_44513_: type_23;
var phi_44562_: u32;
var phi_44563_: u32;
var phi_44564_: u32;
var phi_45225_: i32;
var phi_45236_: i32;
var phi_45264_: type_23;
var phi_45313_: u32;
var phi_45314_: u32;
var phi_45315_: u32;
var phi_45985_: type_23;
var phi_46218_: u32;
var phi_46248_: u32;
var phi_46278_: u32;
var phi_42092_: i32;
var phi_41938_: i32;
var phi_46323_: i32;
var phi_46477_: i32;
var phi_46582_: type_23;
var phi_47009_: f32;
var phi_47278_: type_23;
var phi_47356_: i32;
var phi_47367_: i32;
var phi_47395_: type_23;
var phi_47444_: u32;
var phi_47445_: u32;
var phi_47446_: u32;
var phi_48107_: i32;
var phi_48118_: i32;
var phi_48146_: type_23;
var phi_48195_: u32;
var phi_48196_: u32;
var phi_48197_: u32;
var phi_48858_: i32;
var phi_48869_: i32;
var phi_48897_: type_23;
var phi_48946_: u32;
var phi_48947_: u32;
var phi_48948_: u32;
var phi_49609_: i32;
var phi_49620_: i32;
var phi_49648_: type_23;
var phi_49697_: u32;
var phi_49698_: u32;
var phi_49699_: u32;
var phi_50378_: type_23;
var phi_50456_: i32;
var phi_50467_: i32;
var phi_50495_: type_23;
var phi_50544_: u32;
var phi_50545_: u32;
var phi_50546_: u32;
var phi_51207_: i32;
var phi_51218_: i32;
var phi_51246_: type_23;
var phi_51295_: u32;
var phi_51296_: u32;
var phi_51297_: u32;
var phi_51958_: i32;
var phi_51969_: i32;
var phi_51997_: type_23;
var phi_52046_: u32;
var phi_52047_: u32;
var phi_52048_: u32;
var phi_52709_: i32;
var phi_52720_: i32;
var phi_52748_: type_23;
var phi_52797_: u32;
var phi_52798_: u32;
var phi_52799_: u32;
var phi_53478_: type_23;
var phi_53556_: i32;
var phi_53567_: i32;
var phi_53595_: type_23;
var phi_53644_: u32;
var phi_53645_: u32;
var phi_53646_: u32;
var phi_54307_: i32;
var phi_54318_: i32;
var phi_54346_: type_23;
var phi_54395_: u32;
var phi_54396_: u32;
var phi_54397_: u32;
var phi_55058_: i32;
var phi_55069_: i32;
var phi_55097_: type_23;
var phi_55146_: u32;
var phi_55147_: u32;
var phi_55148_: u32;
var phi_55809_: i32;
var phi_55820_: i32;
var phi_55848_: type_23;
var phi_55897_: u32;
var phi_55898_: u32;
var phi_55899_: u32;
var phi_56569_: type_23;
var phi_56802_: u32;
var phi_56832_: u32;
var phi_56862_: u32;
var phi_46478_: i32;
var phi_46324_: i32;
var phi_56928_: type_23;
var phi_57003_: i32;
var phi_57007_: type_23;
var phi_57010_: i32;
var phi_57161_: type_23;
var phi_57164_: i32;
var phi_57294_: type_23;
var phi_57343_: u32;
var phi_57344_: u32;
var phi_57345_: u32;
var phi_57471_: i32;
var phi_57482_: i32;
var phi_57905_: f32;
var phi_58171_: type_23;
var phi_58368_: u32;
var phi_58369_: u32;
var phi_58370_: u32;
var phi_58404_: u32;
var phi_58434_: u32;
var phi_58464_: u32;
var phi_58501_: type_23;
var phi_57162_: type_23;
var phi_57165_: i32;
var phi_57008_: type_23;
var phi_57011_: i32;
var local_233: type_23;
var local_234: type_23;
var phi_58518_: i32;
var phi_58553_: i32;
var phi_58707_: i32;
var phi_58812_: type_23;
var phi_59239_: f32;
var phi_59484_: type_23;
var phi_59717_: u32;
var phi_59747_: u32;
var phi_59777_: u32;
var phi_58708_: i32;
var phi_58554_: i32;
var phi_59826_: i32;
var phi_59980_: i32;
var phi_60085_: type_23;
var phi_60512_: f32;
var phi_60783_: type_23;
var phi_60861_: i32;
var phi_60872_: i32;
var phi_60900_: type_23;
var phi_60949_: u32;
var phi_60950_: u32;
var phi_60951_: u32;
var phi_61612_: i32;
var phi_61623_: i32;
var phi_61651_: type_23;
var phi_61700_: u32;
var phi_61701_: u32;
var phi_61702_: u32;
var phi_62363_: i32;
var phi_62374_: i32;
var phi_62402_: type_23;
var phi_62451_: u32;
var phi_62452_: u32;
var phi_62453_: u32;
var phi_63114_: i32;
var phi_63125_: i32;
var phi_63153_: type_23;
var phi_63202_: u32;
var phi_63203_: u32;
var phi_63204_: u32;
var phi_63874_: type_23;
var phi_64107_: u32;
var phi_64137_: u32;
var phi_64167_: u32;
var phi_59981_: i32;
var phi_59827_: i32;
var phi_64212_: i32;
var phi_64366_: i32;
var phi_64471_: type_23;
var phi_64898_: f32;
var phi_65167_: type_23;
var phi_65245_: i32;
var phi_65256_: i32;
var phi_65284_: type_23;
var phi_65333_: u32;
var phi_65334_: u32;
var phi_65335_: u32;
var phi_65996_: i32;
var phi_66007_: i32;
var phi_66035_: type_23;
var phi_66084_: u32;
var phi_66085_: u32;
var phi_66086_: u32;
var phi_66747_: i32;
var phi_66758_: i32;
var phi_66786_: type_23;
var phi_66835_: u32;
var phi_66836_: u32;
var phi_66837_: u32;
var phi_67498_: i32;
var phi_67509_: i32;
var phi_67537_: type_23;
var phi_67586_: u32;
var phi_67587_: u32;
var phi_67588_: u32;
var phi_68267_: type_23;
var phi_68345_: i32;
var phi_68356_: i32;
var phi_68384_: type_23;
var phi_68433_: u32;
var phi_68434_: u32;
var phi_68435_: u32;
var phi_69096_: i32;
var phi_69107_: i32;
var phi_69135_: type_23;
var phi_69184_: u32;
var phi_69185_: u32;
var phi_69186_: u32;
var phi_69847_: i32;
var phi_69858_: i32;
var phi_69886_: type_23;
var phi_69935_: u32;
var phi_69936_: u32;
var phi_69937_: u32;
var phi_70598_: i32;
var phi_70609_: i32;
var phi_70637_: type_23;
var phi_70686_: u32;
var phi_70687_: u32;
var phi_70688_: u32;
var phi_71367_: type_23;
var phi_71445_: i32;
var phi_71456_: i32;
var phi_71484_: type_23;
var phi_71533_: u32;
var phi_71534_: u32;
var phi_71535_: u32;
var phi_72196_: i32;
var phi_72207_: i32;
var phi_72235_: type_23;
var phi_72284_: u32;
var phi_72285_: u32;
var phi_72286_: u32;
var phi_72947_: i32;
var phi_72958_: i32;
var phi_72986_: type_23;
var phi_73035_: u32;
var phi_73036_: u32;
var phi_73037_: u32;
var phi_73698_: i32;
var phi_73709_: i32;
var phi_73737_: type_23;
var phi_73786_: u32;
var phi_73787_: u32;
var phi_73788_: u32;
var phi_74458_: type_23;
var phi_74691_: u32;
var phi_74721_: u32;
var phi_74751_: u32;
var phi_64367_: i32;
var phi_64213_: i32;
var local_235: u32;
var local_236: u32;
var local_237: u32;
var local_238: u32;
var local_239: u32;
var local_240: u32;
var local_241: type_23;
var local_242: type_23;
let _e249 = global;
let _e259 = arrayLength((&global_5.member));
let _e262 = arrayLength((&global_6.member));
let _e265 = arrayLength((&global_2.member));
let _e268 = arrayLength((&global_7.member));
let _e270 = arrayLength((&global_8.member));
let _e273 = global_1.member.member;
if (_e249.x < _e273.member) {
if (_e249.y < _e273.member_1) {
let _e281 = bitcast<i32>(_e249.x);
let _e285 = global_1.member.member.member;
let _e286 = bitcast<i32>(_e285);
let _e290 = global_1.member.member_12.member_4;
let _e294 = global_1.member.member_12.member_6;
let _e296 = bitcast<i32>((_e290 * _e294));
let _e298 = bitcast<i32>((_e249.y * 16u));
local_225 = _e296;
local_226 = _e281;
local_227 = _e286;
let _e299 = local_225;
let _e300 = local_227;
let _e303 = local_226;
let _e304 = ((_e299 + (11i * _e300)) + _e303);
let _e306 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e308 = select(_e306, _e304, (_e304 < _e306));
let _e313 = global_4.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e314 = f32(_e298);
if (_e313 < _e314) {
phi_703_ = bool();
phi_704_ = true;
} else {
let _e316 = local_225;
let _e317 = local_227;
let _e320 = local_226;
let _e321 = ((_e316 + (10i * _e317)) + _e320);
let _e323 = select(_e306, _e321, (_e321 < _e306));
let _e328 = global_4.member[bitcast<u32>(select(0i, _e323, (_e323 > 0i)))];
let _e331 = (_e328 > f32((_e298 + 15i)));
if _e331 {
phi_702_ = bool();
} else {
let _e332 = local_225;
let _e333 = local_227;
let _e336 = local_226;
let _e337 = ((_e332 + (11i * _e333)) + _e336);
let _e339 = select(_e306, _e337, (_e337 < _e306));
let _e344 = global_4.member[bitcast<u32>(select(0i, _e339, (_e339 > 0i)))];
phi_702_ = (_e328 <= _e344);
}
let _e347 = phi_702_;
phi_703_ = _e347;
phi_704_ = _e331;
}
let _e349 = phi_703_;
let _e351 = phi_704_;
if select(_e349, false, _e351) {
local_222 = _e296;
local_223 = _e281;
local_224 = _e286;
let _e353 = local_222;
let _e354 = local_224;
let _e357 = local_223;
let _e358 = ((_e353 + (10i * _e354)) + _e357);
let _e360 = select(_e306, _e358, (_e358 < _e306));
let _e365 = global_4.member[bitcast<u32>(select(0i, _e360, (_e360 > 0i)))];
let _e366 = local_222;
let _e367 = local_224;
let _e370 = local_223;
let _e371 = ((_e366 + (11i * _e367)) + _e370);
let _e373 = select(_e306, _e371, (_e371 < _e306));
let _e378 = global_4.member[bitcast<u32>(select(0i, _e373, (_e373 > 0i)))];
let _e379 = local_222;
let _e380 = local_224;
let _e383 = local_223;
let _e384 = ((_e379 + (12i * _e380)) + _e383);
let _e386 = select(_e306, _e384, (_e384 < _e306));
let _e391 = global_4.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e392 = local_222;
let _e393 = local_224;
let _e396 = local_223;
let _e397 = ((_e392 + (13i * _e393)) + _e396);
let _e399 = select(_e306, _e397, (_e397 < _e306));
let _e404 = global_4.member[bitcast<u32>(select(0i, _e399, (_e399 > 0i)))];
local_219 = _e296;
local_220 = _e281;
local_221 = _e286;
let _e405 = local_219;
let _e406 = local_221;
let _e408 = local_220;
let _e409 = ((_e405 + _e406) + _e408);
let _e411 = select(_e306, _e409, (_e409 < _e306));
let _e416 = global_4.member[bitcast<u32>(select(0i, _e411, (_e411 > 0i)))];
let _e417 = local_219;
let _e418 = local_221;
let _e421 = local_220;
let _e422 = ((_e417 + (2i * _e418)) + _e421);
let _e424 = select(_e306, _e422, (_e422 < _e306));
let _e429 = global_4.member[bitcast<u32>(select(0i, _e424, (_e424 > 0i)))];
let _e430 = local_219;
let _e431 = local_221;
let _e434 = local_220;
let _e435 = ((_e430 + (3i * _e431)) + _e434);
let _e437 = select(_e306, _e435, (_e435 < _e306));
let _e442 = global_4.member[bitcast<u32>(select(0i, _e437, (_e437 > 0i)))];
let _e443 = local_219;
let _e444 = local_220;
let _e445 = (_e443 + _e444);
let _e447 = select(_e306, _e445, (_e445 < _e306));
let _e452 = global_4.member[bitcast<u32>(select(0i, _e447, (_e447 > 0i)))];
let _e453 = (_e452 > 0f);
let _e454 = local_219;
let _e455 = local_221;
let _e458 = local_220;
let _e459 = ((_e454 + (4i * _e455)) + _e458);
let _e461 = select(_e306, _e459, (_e459 < _e306));
let _e466 = global_4.member[bitcast<u32>(select(0i, _e461, (_e461 > 0i)))];
let _e467 = local_219;
let _e468 = local_221;
let _e471 = local_220;
let _e472 = ((_e467 + (5i * _e468)) + _e471);
let _e474 = select(_e306, _e472, (_e472 < _e306));
let _e479 = global_4.member[bitcast<u32>(select(0i, _e474, (_e474 > 0i)))];
let _e480 = local_219;
let _e481 = local_221;
let _e484 = local_220;
let _e485 = ((_e480 + (6i * _e481)) + _e484);
let _e487 = select(_e306, _e485, (_e485 < _e306));
let _e492 = global_4.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e493 = local_219;
let _e494 = local_221;
let _e497 = local_220;
let _e498 = ((_e493 + (7i * _e494)) + _e497);
let _e500 = select(_e306, _e498, (_e498 < _e306));
let _e505 = global_4.member[bitcast<u32>(select(0i, _e500, (_e500 > 0i)))];
let _e506 = local_219;
let _e507 = local_221;
let _e510 = local_220;
let _e511 = ((_e506 + (8i * _e507)) + _e510);
let _e513 = select(_e306, _e511, (_e511 < _e306));
let _e518 = global_4.member[bitcast<u32>(select(0i, _e513, (_e513 > 0i)))];
let _e519 = local_219;
let _e520 = local_221;
let _e523 = local_220;
let _e524 = ((_e519 + (9i * _e520)) + _e523);
let _e526 = select(_e306, _e524, (_e524 < _e306));
let _e531 = global_4.member[bitcast<u32>(select(0i, _e526, (_e526 > 0i)))];
let _e534 = bitcast<f32>((bitcast<u32>(_e429) & 2147483647u));
let _e538 = global_1.member.member_1.member;
let _e542 = global_1.member.member_1.member_1;
let _e543 = bitcast<i32>(_e538);
let _e544 = bitcast<i32>(_e542);
if _e453 {
phi_1084_ = type_23(_e544, _e543);
} else {
phi_1084_ = type_23(_e543, _e544);
}
let _e548 = phi_1084_;
let _e553 = global_1.member.member_12.member_9;
if ((_e453 != (_e553 == 1u)) || (_e298 >= _e548.member)) {
} else {
let _e561 = global_1.member.member_12.member_5;
local_216 = bitcast<i32>((_e290 * _e561));
local_217 = _e281;
local_218 = _e286;
let _e564 = local_216;
let _e565 = local_217;
let _e566 = (_e564 + _e565);
let _e568 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e570 = select(_e568, _e566, (_e566 < _e568));
let _e575 = global_3.member[bitcast<u32>(select(0i, _e570, (_e570 > 0i)))];
let _e576 = local_216;
let _e577 = local_218;
let _e579 = local_217;
let _e580 = ((_e576 + _e577) + _e579);
let _e582 = select(_e568, _e580, (_e580 < _e568));
let _e587 = global_3.member[bitcast<u32>(select(0i, _e582, (_e582 > 0i)))];
let _e588 = local_216;
let _e589 = local_218;
let _e592 = local_217;
let _e593 = ((_e588 + (2i * _e589)) + _e592);
let _e595 = select(_e568, _e593, (_e593 < _e568));
let _e600 = global_3.member[bitcast<u32>(select(0i, _e595, (_e595 > 0i)))];
let _e601 = local_216;
let _e602 = local_218;
let _e605 = local_217;
let _e606 = ((_e601 + (3i * _e602)) + _e605);
let _e608 = select(_e568, _e606, (_e606 < _e568));
let _e613 = global_3.member[bitcast<u32>(select(0i, _e608, (_e608 > 0i)))];
let _e614 = local_216;
let _e615 = local_218;
let _e618 = local_217;
let _e619 = ((_e614 + (4i * _e615)) + _e618);
let _e621 = select(_e568, _e619, (_e619 < _e568));
let _e626 = global_3.member[bitcast<u32>(select(0i, _e621, (_e621 > 0i)))];
let _e627 = local_216;
let _e628 = local_218;
let _e631 = local_217;
let _e632 = ((_e627 + (5i * _e628)) + _e631);
let _e634 = select(_e568, _e632, (_e632 < _e568));
let _e639 = global_3.member[bitcast<u32>(select(0i, _e634, (_e634 > 0i)))];
let _e640 = local_216;
let _e641 = local_218;
let _e644 = local_217;
let _e645 = ((_e640 + (18i * _e641)) + _e644);
let _e647 = select(_e568, _e645, (_e645 < _e568));
let _e652 = global_3.member[bitcast<u32>(select(0i, _e647, (_e647 > 0i)))];
let _e653 = local_216;
let _e654 = local_218;
let _e657 = local_217;
let _e658 = ((_e653 + (19i * _e654)) + _e657);
let _e660 = select(_e568, _e658, (_e658 < _e568));
let _e665 = global_3.member[bitcast<u32>(select(0i, _e660, (_e660 > 0i)))];
let _e666 = local_216;
let _e667 = local_218;
let _e670 = local_217;
let _e671 = ((_e666 + (20i * _e667)) + _e670);
let _e673 = select(_e568, _e671, (_e671 < _e568));
let _e678 = global_3.member[bitcast<u32>(select(0i, _e673, (_e673 > 0i)))];
let _e679 = local_216;
let _e680 = local_218;
let _e683 = local_217;
let _e684 = ((_e679 + (23i * _e680)) + _e683);
let _e686 = select(_e568, _e684, (_e684 < _e568));
let _e691 = global_3.member[bitcast<u32>(select(0i, _e686, (_e686 > 0i)))];
let _e692 = (_e298 + 16i);
let _e694 = (0.5f * (16f - 1f));
let _e695 = (_e314 + _e694);
let _e699 = (-(((_e416 * _e695) + _e442)) / _e429);
let _e717 = (0.5f * 1f);
let _e719 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e466 * _e695) + ((_e479 * _e699) + _e492))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e505 * _e695) + ((_e518 * _e699) + _e531))) & 2147483647u)))) / _e534) + _e717));
let _e723 = global_1.member.member_18.member_1;
phi_1796_ = 8f;
phi_1799_ = 0u;
loop {
let _e725 = phi_1796_;
let _e727 = phi_1799_;
local_228 = _e727;
local_235 = _e727;
let _e730 = ((_e727 < _e723) && (_e719 >= _e725));
if _e730 {
phi_1797_ = (_e725 * 2f);
phi_1800_ = (_e727 + 1u);
} else {
phi_1797_ = f32();
phi_1800_ = u32();
}
let _e734 = phi_1797_;
let _e736 = phi_1800_;
continue;
continuing {
phi_1796_ = _e734;
phi_1799_ = _e736;
break if !(_e730);
}
}
let _e739 = local_228;
let _e743 = f32((1i << bitcast<u32>((_e739 & 31u))));
let _e746 = f32(_e692);
if (((_e314 - _e743) > _e391) && ((_e746 + _e743) < _e404)) {
let _e25755 = local_235;
phi_1844_ = _e25755;
} else {
phi_1829_ = 8f;
phi_1832_ = 0u;
loop {
let _e752 = phi_1829_;
let _e754 = phi_1832_;
local_236 = _e754;
let _e757 = ((_e754 < _e723) && ((_e719 * 0.125f) >= _e752));
if _e757 {
phi_1830_ = (_e752 * 2f);
phi_1833_ = (_e754 + 1u);
} else {
phi_1830_ = f32();
phi_1833_ = u32();
}
let _e761 = phi_1830_;
let _e763 = phi_1833_;
continue;
continuing {
phi_1829_ = _e761;
phi_1832_ = _e763;
break if !(_e757);
}
}
let _e25757 = local_236;
phi_1844_ = _e25757;
}
let _e766 = phi_1844_;
let _e767 = (_e298 - 16i);
let _e771 = (_e365 <= _e378);
let _e772 = f32(_e767);
if (((_e767 >= 0i) && (_e767 < _e548.member)) && ((_e771 && (_e378 >= _e772)) && (_e365 <= f32((_e298 - 1i))))) {
let _e780 = (_e772 + _e694);
let _e784 = (-(((_e416 * _e780) + _e442)) / _e429);
let _e803 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e466 * _e780) + ((_e479 * _e784) + _e492))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e505 * _e780) + ((_e518 * _e784) + _e531))) & 2147483647u)))) / _e534) + _e717));
phi_1899_ = 8f;
phi_1902_ = 0u;
loop {
let _e805 = phi_1899_;
let _e807 = phi_1902_;
local_229 = _e807;
local_237 = _e807;
let _e810 = ((_e807 < _e723) && (_e803 >= _e805));
if _e810 {
phi_1900_ = (_e805 * 2f);
phi_1903_ = (_e807 + 1u);
} else {
phi_1900_ = f32();
phi_1903_ = u32();
}
let _e814 = phi_1900_;
let _e816 = phi_1903_;
continue;
continuing {
phi_1899_ = _e814;
phi_1902_ = _e816;
break if !(_e810);
}
}
let _e819 = local_229;
let _e823 = f32((1i << bitcast<u32>((_e819 & 31u))));
if (((_e772 - _e823) > _e391) && ((_e314 + _e823) < _e404)) {
let _e25769 = local_237;
phi_1947_ = _e25769;
} else {
phi_1932_ = 8f;
phi_1935_ = 0u;
loop {
let _e831 = phi_1932_;
let _e833 = phi_1935_;
local_238 = _e833;
let _e836 = ((_e833 < _e723) && ((_e803 * 0.125f) >= _e831));
if _e836 {
phi_1933_ = (_e831 * 2f);
phi_1936_ = (_e833 + 1u);
} else {
phi_1933_ = f32();
phi_1936_ = u32();
}
let _e840 = phi_1933_;
let _e842 = phi_1936_;
continue;
continuing {
phi_1932_ = _e840;
phi_1935_ = _e842;
break if !(_e836);
}
}
let _e25771 = local_238;
phi_1947_ = _e25771;
}
let _e845 = phi_1947_;
phi_1948_ = _e845;
} else {
phi_1948_ = _e766;
}
let _e847 = phi_1948_;
if (((_e692 >= 0i) && (_e692 < _e548.member)) && ((_e771 && (_e378 >= _e746)) && (_e365 <= f32((_e298 + 31i))))) {
let _e859 = (_e746 + _e694);
let _e863 = (-(((_e416 * _e859) + _e442)) / _e429);
let _e882 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e466 * _e859) + ((_e479 * _e863) + _e492))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e505 * _e859) + ((_e518 * _e863) + _e531))) & 2147483647u)))) / _e534) + _e717));
phi_2003_ = 8f;
phi_2006_ = 0u;
loop {
let _e884 = phi_2003_;
let _e886 = phi_2006_;
local_230 = _e886;
local_239 = _e886;
let _e889 = ((_e886 < _e723) && (_e882 >= _e884));
if _e889 {
phi_2004_ = (_e884 * 2f);
phi_2007_ = (_e886 + 1u);
} else {
phi_2004_ = f32();
phi_2007_ = u32();
}
let _e893 = phi_2004_;
let _e895 = phi_2007_;
continue;
continuing {
phi_2003_ = _e893;
phi_2006_ = _e895;
break if !(_e889);
}
}
let _e898 = local_230;
let _e902 = f32((1i << bitcast<u32>((_e898 & 31u))));
if (((_e746 - _e902) > _e391) && ((f32((_e298 + 32i)) + _e902) < _e404)) {
let _e25784 = local_239;
phi_2051_ = _e25784;
} else {
phi_2036_ = 8f;
phi_2039_ = 0u;
loop {
let _e911 = phi_2036_;
let _e913 = phi_2039_;
local_240 = _e913;
let _e916 = ((_e913 < _e723) && ((_e882 * 0.125f) >= _e911));
if _e916 {
phi_2037_ = (_e911 * 2f);
phi_2040_ = (_e913 + 1u);
} else {
phi_2037_ = f32();
phi_2040_ = u32();
}
let _e920 = phi_2037_;
let _e922 = phi_2040_;
continue;
continuing {
phi_2036_ = _e920;
phi_2039_ = _e922;
break if !(_e916);
}
}
let _e25786 = local_240;
phi_2051_ = _e25786;
}
let _e925 = phi_2051_;
phi_2052_ = _e925;
} else {
phi_2052_ = _e766;
}
let _e927 = phi_2052_;
if (_e273.member_2 == 1u) {
let _e931 = global_1.member.member_1.member;
let _e934 = global_1.member.member_1.member_1;
let _e935 = bitcast<i32>(_e931);
let _e936 = bitcast<i32>(_e934);
if _e453 {
phi_2098_ = type_23(_e936, _e935);
} else {
phi_2098_ = type_23(_e935, _e936);
}
let _e940 = phi_2098_;
let _e944 = f32((_e298 + 15i));
let _e946 = select(_e944, _e378, (_e378 < _e944));
let _e948 = select(_e314, _e946, (_e946 > _e314));
let _e950 = select(_e944, _e948, (_e948 < _e944));
let _e957 = select(0i, select(select(i32(_e950), i32(-2147483648), (_e950 < -2147483600f)), 2147483647i, (_e950 > 2147483500f)), (_e950 == _e950));
let _e961 = (_e957 - select(0i, 1i, (_e950 < f32(_e957))));
let _e962 = bitcast<i32>(_e961);
let _e964 = select(_e314, _e365, (_e365 > _e314));
let _e966 = select(_e314, _e964, (_e964 > _e314));
let _e968 = select(_e944, _e966, (_e966 < _e944));
let _e975 = select(0i, select(select(i32(_e968), i32(-2147483648), (_e968 < -2147483600f)), 2147483647i, (_e968 > 2147483500f)), (_e968 == _e968));
let _e979 = (_e975 - select(0i, 1i, (_e968 < f32(_e975))));
let _e980 = bitcast<i32>(_e979);
if (_e962 < _e940.member) {
phi_2173_ = _e962;
} else {
phi_2173_ = (_e940.member - 1i);
}
let _e984 = phi_2173_;
let _e985 = (_e940.member_1 - 1i);
let _e986 = (_e766 == 0u);
if _e986 {
let _e988 = select(_e847, 0u, (_e847 == _e766));
let _e992 = select(_e927, 0u, ((_e927 == _e766) || (_e927 == _e847)));
let _e1000 = ((select(0u, 1u, (_e766 > 0u)) + select(0u, 1u, (_e988 > 0u))) + select(0u, 1u, (_e992 > 0u)));
if (_e1000 == 0u) {
phi_2211_ = 0i;
loop {
let _e1003 = phi_2211_;
let _e1004 = (_e1003 < 16i);
if _e1004 {
let _e1006 = (_e980 + (_e1003 & 15i));
let _e1010 = (((f32(_e1006) + 0.5f) * 1f) - 0.5f);
let _e1014 = (-(((_e416 * _e1010) + _e442)) / _e429);
let _e1021 = bitcast<f32>((bitcast<u32>(((_e466 * _e1010) + ((_e479 * _e1014) + _e492))) & 2147483647u));
let _e1028 = bitcast<f32>((bitcast<u32>(((_e505 * _e1010) + ((_e518 * _e1014) + _e531))) & 2147483647u));
let _e1032 = (((0.5f * (_e1021 + _e1028)) / _e534) + _e717);
let _e1033 = (1f / 1f);
let _e1041 = ((((_e1014 + _e1032) + 0.5f) * _e1033) - 0.5f);
let _e1042 = f32(_e985);
let _e1043 = (0f - 1f);
let _e1045 = select(_e1043, _e1041, (_e1041 > _e1043));
let _e1047 = select(_e1042, _e1045, (_e1045 < _e1042));
let _e1054 = select(0i, select(select(i32(_e1047), i32(-2147483648), (_e1047 < -2147483600f)), 2147483647i, (_e1047 > 2147483500f)), (_e1047 == _e1047));
let _e1059 = (((((_e1014 - _e1032) + 0.5f) * _e1033) - 0.5f) + 1f);
let _e1060 = (_e1042 + 1f);
let _e1062 = select(0f, _e1059, (_e1059 > 0f));
let _e1064 = select(_e1060, _e1062, (_e1062 < _e1060));
let _e1071 = select(0i, select(select(i32(_e1064), i32(-2147483648), (_e1064 < -2147483600f)), 2147483647i, (_e1064 > 2147483500f)), (_e1064 == _e1064));
let _e1082 = ((1e-4f * 1f) * _e534);
let _e1084 = select(_e1028, _e1021, (_e1021 > _e1028));
let _e1086 = select(_e1082, _e1084, (_e1084 > _e1082));
let _e1088 = select(_e1028, _e1021, (_e1021 < _e1028));
let _e1090 = select(_e1082, _e1088, (_e1088 > _e1082));
let _e1092 = (0.5f * (_e1086 + _e1090));
let _e1093 = (0.5f / _e1090);
let _e1094 = (1f / _e1086);
phi_2365_ = 0i;
loop {
let _e1096 = phi_2365_;
let _e1098 = (((_e1071 - select(0i, 1i, (_e1064 < f32(_e1071)))) + (_e1003 >> bitcast<u32>(4u))) + bitcast<i32>(_e1096));
let _e1099 = (_e1098 <= select(-1i, (_e1054 - select(0i, 1i, (_e1047 < f32(_e1054)))), (_e1006 <= _e984)));
if _e1099 {
let _e1105 = (((((f32(_e1098) + 0.5f) * 1f) - 0.5f) - _e1014) * _e534);
let _e1106 = (_e534 * 1f);
let _e1108 = (0.5f * _e1106);
let _e1109 = (_e1105 + _e1108);
let _e1110 = -(_e1109);
let _e1113 = (_e1092 - select(_e1110, _e1109, (_e1109 > _e1110)));
let _e1115 = select(0f, _e1113, (_e1113 > 0f));
let _e1117 = select(_e1090, _e1115, (_e1115 < _e1090));
let _e1120 = (_e1113 - _e1090);
let _e1124 = (((_e1117 * (_e1117 * _e1093)) + select(0f, _e1120, (_e1120 > 0f))) * _e1094);
let _e1128 = (_e1105 - _e1108);
let _e1129 = -(_e1128);
let _e1132 = (_e1092 - select(_e1129, _e1128, (_e1128 > _e1129)));
let _e1134 = select(0f, _e1132, (_e1132 > 0f));
let _e1136 = select(_e1090, _e1134, (_e1134 < _e1090));
let _e1139 = (_e1132 - _e1090);
let _e1143 = (((_e1136 * (_e1136 * _e1093)) + select(0f, _e1139, (_e1139 > 0f))) * _e1094);
if _e453 {
phi_2470_ = type_23(_e1098, _e1006);
} else {
phi_2470_ = type_23(_e1006, _e1098);
}
let _e1152 = phi_2470_;
let _e1156 = bitcast<i32>((_e931 * _e934));
local_214 = _e1156;
local_215 = ((_e1152.member_1 * _e935) + _e1152.member);
let _e1159 = local_214;
let _e1160 = local_215;
let _e1161 = (_e1159 + _e1160);
let _e1163 = (bitcast<i32>(_e259) - 1i);
let _e1165 = select(_e1163, _e1161, (_e1161 < _e1163));
let _e1170 = global_5.member[bitcast<u32>(select(0i, _e1165, (_e1165 > 0i)))];
let _e1171 = local_214;
let _e1173 = local_215;
let _e1174 = ((2i * _e1171) + _e1173);
let _e1176 = select(_e1163, _e1174, (_e1174 < _e1163));
let _e1181 = global_5.member[bitcast<u32>(select(0i, _e1176, (_e1176 > 0i)))];
let _e1182 = local_215;
let _e1184 = select(_e1163, _e1182, (_e1182 < _e1163));
let _e1189 = global_5.member[bitcast<u32>(select(0i, _e1184, (_e1184 > 0i)))];
let _e1190 = local_215;
let _e1201 = global_1.member.member_2.member;
let _e1202 = (((((f32(_e1152.member) + 0.5f) / f32(_e935)) * 2f) - 1f) * _e1201);
let _e1209 = global_1.member.member_2.member_1;
let _e1210 = ((1f - (((f32(_e1152.member_1) + 0.5f) / f32(_e936)) * 2f)) * _e1209);
let _e1212 = global_1.member.member_3;
let _e1220 = global_1.member.member_4;
let _e1227 = ((_e1212.member * _e1202) + (_e1220.member * _e1210));
let _e1228 = ((_e1212.member_1 * _e1202) + (_e1220.member_1 * _e1210));
let _e1229 = ((_e1212.member_2 * _e1202) + (_e1220.member_2 * _e1210));
let _e1232 = global_1.member.member_2.member_3;
let _e1233 = (_e1232 != 0u);
let _e1235 = global_1.member.member_5;
let _e1242 = select((_e1235.member + _e1227), _e1235.member, _e1233);
let _e1243 = select((_e1235.member_1 + _e1228), _e1235.member_1, _e1233);
let _e1244 = select((_e1235.member_2 + _e1229), _e1235.member_2, _e1233);
let _e1246 = global_1.member.member_6;
let _e1253 = select(_e1246.member, (_e1246.member + _e1227), _e1233);
let _e1254 = select(_e1246.member_1, (_e1246.member_1 + _e1228), _e1233);
let _e1255 = select(_e1246.member_2, (_e1246.member_2 + _e1229), _e1233);
let _e1260 = (((_e1242 * _e1242) + (_e1243 * _e1243)) + (_e1244 * _e1244));
let _e1263 = sqrt(select(0f, _e1260, (_e1260 > 0f)));
let _e1264 = (1f / _e1263);
let _e1265 = (_e1242 * _e1264);
let _e1266 = (_e1243 * _e1264);
let _e1267 = (_e1244 * _e1264);
let _e1268 = (_e575 - _e1253);
let _e1269 = (_e587 - _e1254);
let _e1270 = (_e600 - _e1255);
let _e1275 = (((_e1268 * _e1265) + (_e1269 * _e1266)) + (_e1270 * _e1267));
let _e1280 = (((_e1268 * _e613) + (_e1269 * _e626)) + (_e1270 * _e639));
let _e1285 = (((_e1265 * _e613) + (_e1266 * _e626)) + (_e1267 * _e639));
let _e1288 = ((_e1266 * _e639) - (_e1267 * _e626));
let _e1291 = ((_e1267 * _e613) - (_e1265 * _e639));
let _e1294 = ((_e1265 * _e626) - (_e1266 * _e613));
let _e1299 = (((_e1288 * _e1288) + (_e1291 * _e1291)) + (_e1294 * _e1294));
let _e1302 = (1f / select(1e-9f, _e1299, (_e1299 > 1e-9f)));
let _e1305 = ((_e1275 - (_e1285 * _e1280)) * _e1302);
let _e1308 = (((_e1285 * _e1275) - _e1280) * _e1302);
let _e1314 = -(_e1285);
let _e1317 = global_1.member.member_13.member_2;
let _e1318 = (_e1317 * _e1317);
let _e1322 = ((1f + _e1318) - ((2f * _e1317) * _e1314));
let _e1324 = select(1e-9f, _e1322, (_e1322 > 1e-9f));
let _e1336 = global_1.member.member_13.member_3;
if (_e1336 == 2u) {
let _e1341 = (0.5f - (0.5f * _e1314));
let _e1343 = select(0f, _e1341, (_e1341 > 0f));
let _e1347 = (sqrt(select(0f, _e1343, (_e1343 > 0f))) * 255f);
let _e1348 = (255f - 1f);
let _e1350 = select(0f, _e1347, (_e1347 > 0f));
let _e1352 = select(_e1348, _e1350, (_e1350 < _e1348));
let _e1359 = select(0i, select(select(i32(_e1352), i32(-2147483648), (_e1352 < -2147483600f)), 2147483647i, (_e1352 > 2147483500f)), (_e1352 == _e1352));
let _e1363 = (_e1359 - select(0i, 1i, (_e1352 < f32(_e1359))));
let _e1366 = global_1.member.member_13.member_11;
let _e1367 = bitcast<i32>(_e1366);
let _e1368 = (_e1367 + _e1363);
let _e1370 = (bitcast<i32>(_e265) - 1i);
let _e1372 = select(_e1370, _e1368, (_e1368 < _e1370));
let _e1377 = global_2.member[bitcast<u32>(select(0i, _e1372, (_e1372 > 0i)))];
let _e1379 = (_e1367 + (_e1363 + 1i));
let _e1381 = select(_e1370, _e1379, (_e1379 < _e1370));
let _e1386 = global_2.member[bitcast<u32>(select(0i, _e1381, (_e1381 > 0i)))];
phi_2897_ = (_e1377 + ((_e1386 - _e1377) * (_e1347 - f32(_e1363))));
} else {
phi_2897_ = select(((1f - _e1318) / (_e1324 * sqrt(select(0f, _e1324, (_e1324 > 0f))))), (0.75f * (1f + (_e1314 * _e1314))), (_e1336 == 1u));
}
let _e1393 = phi_2897_;
let _e1399 = global_1.member.member_12.member_11;
let _e1402 = global_1.member.member_12.member_4;
let _e1405 = global_1.member.member_12.member_12;
let _e1411 = global_1.member.member.member;
let _e1413 = (_e1308 / _e691);
local_211 = bitcast<i32>((_e1399 + (_e1402 * _e1405)));
local_212 = _e281;
local_213 = bitcast<i32>(_e1411);
let _e1416 = global_1.member.member_13.member_6;
let _e1417 = f32(_e1416);
let _e1419 = select(0f, _e1413, (_e1413 > 0f));
let _e1422 = (select(1f, _e1419, (_e1419 < 1f)) * _e1417);
let _e1423 = (_e1417 - 1f);
let _e1425 = select(0f, _e1423, (_e1423 > 0f));
let _e1427 = select(0f, _e1422, (_e1422 > 0f));
let _e1429 = select(_e1425, _e1427, (_e1427 < _e1425));
let _e1436 = select(0i, select(select(i32(_e1429), i32(-2147483648), (_e1429 < -2147483600f)), 2147483647i, (_e1429 > 2147483500f)), (_e1429 == _e1429));
let _e1440 = (_e1436 - select(0i, 1i, (_e1429 < f32(_e1436))));
if (_e1440 > 0i) {
let _e1443 = local_211;
let _e1444 = local_213;
let _e1447 = local_212;
let _e1448 = ((_e1443 + ((_e1440 - 1i) * _e1444)) + _e1447);
let _e1450 = (bitcast<i32>(_e268) - 1i);
let _e1452 = select(_e1450, _e1448, (_e1448 < _e1450));
let _e1457 = global_7.member[bitcast<u32>(select(0i, _e1452, (_e1452 > 0i)))];
phi_3003_ = _e1457;
} else {
phi_3003_ = 0f;
}
let _e1459 = phi_3003_;
let _e1460 = local_211;
let _e1461 = local_213;
let _e1464 = local_212;
let _e1465 = ((_e1460 + (_e1440 * _e1461)) + _e1464);
let _e1467 = (bitcast<i32>(_e268) - 1i);
let _e1469 = select(_e1467, _e1465, (_e1465 < _e1467));
let _e1474 = global_7.member[bitcast<u32>(select(0i, _e1469, (_e1469 > 0i)))];
let _e1481 = (_e1181 - _e1170);
let _e1484 = ((_e1305 - _e1170) / select(1e-9f, _e1481, (_e1481 > 1e-9f)));
local_208 = 0i;
local_209 = _e1190;
local_210 = _e1156;
let _e1486 = select(0f, _e1484, (_e1484 > 0f));
let _e1489 = (select(1f, _e1486, (_e1486 < 1f)) * _e1417);
let _e1491 = select(0f, _e1489, (_e1489 > 0f));
let _e1493 = select(_e1425, _e1491, (_e1491 < _e1425));
let _e1500 = select(0i, select(select(i32(_e1493), i32(-2147483648), (_e1493 < -2147483600f)), 2147483647i, (_e1493 > 2147483500f)), (_e1493 == _e1493));
let _e1504 = (_e1500 - select(0i, 1i, (_e1493 < f32(_e1500))));
if (_e1504 > 0i) {
let _e1507 = local_208;
let _e1508 = local_210;
let _e1511 = local_209;
let _e1512 = ((_e1507 + ((_e1504 - 1i) * _e1508)) + _e1511);
let _e1514 = select(_e1467, _e1512, (_e1512 < _e1467));
let _e1519 = global_7.member[bitcast<u32>(select(0i, _e1514, (_e1514 > 0i)))];
phi_3130_ = _e1519;
} else {
phi_3130_ = 0f;
}
let _e1521 = phi_3130_;
let _e1522 = local_208;
let _e1523 = local_210;
let _e1526 = local_209;
let _e1527 = ((_e1522 + (_e1504 * _e1523)) + _e1526);
let _e1529 = select(_e1467, _e1527, (_e1527 < _e1467));
let _e1534 = global_7.member[bitcast<u32>(select(0i, _e1529, (_e1529 > 0i)))];
let _e1540 = ((_e1459 + ((_e1474 - _e1459) * (_e1422 - f32(_e1440)))) + (_e1521 + ((_e1534 - _e1521) * (_e1489 - f32(_e1504)))));
let _e1549 = global_1.member.member_13.member_7;
let _e1550 = bitcast<i32>(_e1549);
let _e1553 = global_1.member.member_13.member_8;
let _e1554 = bitcast<i32>(_e1553);
let _e1557 = global_1.member.member_13.member_9;
let _e1558 = bitcast<i32>(_e1557);
let _e1561 = global_1.member.member_13.member_4;
let _e1567 = global_1.member.member_13.member_5;
let _e1571 = f32(_e1550);
let _e1576 = (((((_e1253 + (_e1265 * _e1305)) - _e1561.member) / (_e1567.member - _e1561.member)) * _e1571) - 0.5f);
let _e1577 = (_e1571 - 1f);
let _e1579 = select(0f, _e1576, (_e1576 > 0f));
let _e1581 = select(_e1577, _e1579, (_e1579 < _e1577));
let _e1582 = f32(_e1554);
let _e1587 = (((((_e1254 + (_e1266 * _e1305)) - _e1561.member_1) / (_e1567.member_1 - _e1561.member_1)) * _e1582) - 0.5f);
let _e1588 = (_e1582 - 1f);
let _e1590 = select(0f, _e1587, (_e1587 > 0f));
let _e1592 = select(_e1588, _e1590, (_e1590 < _e1588));
let _e1593 = f32(_e1558);
let _e1598 = (((((_e1255 + (_e1267 * _e1305)) - _e1561.member_2) / (_e1567.member_2 - _e1561.member_2)) * _e1593) - 0.5f);
let _e1599 = (_e1593 - 1f);
let _e1601 = select(0f, _e1598, (_e1598 > 0f));
let _e1603 = select(_e1599, _e1601, (_e1601 < _e1599));
let _e1605 = select(0f, _e1581, (_e1581 > 0f));
let _e1607 = select(1e6f, _e1605, (_e1605 < 1e6f));
let _e1614 = select(0i, select(select(i32(_e1607), i32(-2147483648), (_e1607 < -2147483600f)), 2147483647i, (_e1607 > 2147483500f)), (_e1607 == _e1607));
let _e1618 = (_e1614 - select(0i, 1i, (_e1607 < f32(_e1614))));
let _e1620 = select(0f, _e1592, (_e1592 > 0f));
let _e1622 = select(1e6f, _e1620, (_e1620 < 1e6f));
let _e1629 = select(0i, select(select(i32(_e1622), i32(-2147483648), (_e1622 < -2147483600f)), 2147483647i, (_e1622 > 2147483500f)), (_e1622 == _e1622));
let _e1633 = (_e1629 - select(0i, 1i, (_e1622 < f32(_e1629))));
let _e1635 = select(0f, _e1603, (_e1603 > 0f));
let _e1637 = select(1e6f, _e1635, (_e1635 < 1e6f));
let _e1644 = select(0i, select(select(i32(_e1637), i32(-2147483648), (_e1637 < -2147483600f)), 2147483647i, (_e1637 > 2147483500f)), (_e1637 == _e1637));
let _e1648 = (_e1644 - select(0i, 1i, (_e1637 < f32(_e1644))));
let _e1652 = (_e1592 - f32(_e1633));
let _e1654 = (_e1603 - f32(_e1648));
local_206 = (_e1581 - f32(_e1618));
let _e1655 = (_e1618 + 1i);
let _e1657 = select(_e1655, 0i, (_e1655 < 0i));
if (_e1657 >= _e1550) {
phi_3278_ = (_e1550 - 1i);
} else {
phi_3278_ = _e1657;
}
let _e1661 = phi_3278_;
local_207 = (_e1661 - _e1618);
let _e1663 = (_e1633 + 1i);
let _e1665 = select(_e1663, 0i, (_e1663 < 0i));
if (_e1665 >= _e1554) {
phi_3291_ = (_e1554 - 1i);
} else {
phi_3291_ = _e1665;
}
let _e1669 = phi_3291_;
let _e1671 = ((_e1669 - _e1633) * _e1550);
let _e1672 = (_e1648 + 1i);
let _e1674 = select(_e1672, 0i, (_e1672 < 0i));
if (_e1674 >= _e1558) {
phi_3305_ = (_e1558 - 1i);
} else {
phi_3305_ = _e1674;
}
let _e1678 = phi_3305_;
let _e1684 = global_1.member.member_13.member_10;
let _e1690 = ((bitcast<i32>(_e1684) + (((_e1648 * _e1554) + _e1633) * _e1550)) + _e1618);
let _e1692 = (bitcast<i32>(_e265) - 1i);
let _e1694 = select(_e1692, _e1690, (_e1690 < _e1692));
let _e1699 = global_2.member[bitcast<u32>(select(0i, _e1694, (_e1694 > 0i)))];
let _e1700 = local_206;
let _e1703 = local_207;
let _e1704 = (_e1690 + _e1703);
let _e1706 = select(_e1692, _e1704, (_e1704 < _e1692));
let _e1711 = global_2.member[bitcast<u32>(select(0i, _e1706, (_e1706 > 0i)))];
let _e1712 = local_206;
let _e1715 = (1f - _e1652);
let _e1717 = (_e1690 + _e1671);
let _e1719 = select(_e1692, _e1717, (_e1717 < _e1692));
let _e1724 = global_2.member[bitcast<u32>(select(0i, _e1719, (_e1719 > 0i)))];
let _e1725 = local_206;
let _e1728 = local_207;
let _e1729 = (_e1717 + _e1728);
let _e1731 = select(_e1692, _e1729, (_e1729 < _e1692));
let _e1736 = global_2.member[bitcast<u32>(select(0i, _e1731, (_e1731 > 0i)))];
let _e1737 = local_206;
let _e1742 = (_e1690 + (((_e1678 - _e1648) * _e1550) * _e1554));
let _e1744 = select(_e1692, _e1742, (_e1742 < _e1692));
let _e1749 = global_2.member[bitcast<u32>(select(0i, _e1744, (_e1744 > 0i)))];
let _e1750 = local_206;
let _e1753 = local_207;
let _e1754 = (_e1742 + _e1753);
let _e1756 = select(_e1692, _e1754, (_e1754 < _e1692));
let _e1761 = global_2.member[bitcast<u32>(select(0i, _e1756, (_e1756 > 0i)))];
let _e1762 = local_206;
let _e1766 = (_e1742 + _e1671);
let _e1768 = select(_e1692, _e1766, (_e1766 < _e1692));
let _e1773 = global_2.member[bitcast<u32>(select(0i, _e1768, (_e1768 > 0i)))];
let _e1774 = local_206;
let _e1777 = local_207;
let _e1778 = (_e1766 + _e1777);
let _e1780 = select(_e1692, _e1778, (_e1778 < _e1692));
let _e1785 = global_2.member[bitcast<u32>(select(0i, _e1780, (_e1780 > 0i)))];
let _e1786 = local_206;
let _e1795 = ((_e1263 * (_e1393 * (0.25f / 3.1415927f))) * ((((((_e1699 * (1f - _e1700)) + (_e1711 * _e1712)) * _e1715) + (((_e1724 * (1f - _e1725)) + (_e1736 * _e1737)) * _e1652)) * (1f - _e1654)) + (((((_e1749 * (1f - _e1750)) + (_e1761 * _e1762)) * _e1715) + (((_e1773 * (1f - _e1774)) + (_e1785 * _e1786)) * _e1652)) * _e1654)));
let _e1798 = global_1.member.member_13.member_1;
let _e1807 = global_1.member.member_13.member;
let _e1812 = -((_e1807.member * _e1540));
let _e1814 = select(-87f, _e1812, (_e1812 > -87f));
let _e1816 = select(88f, _e1814, (_e1814 < 88f));
let _e1818 = ((_e1816 * 1.442695f) + 0.5f);
let _e1820 = select(-127f, _e1818, (_e1818 > -127f));
let _e1822 = select(128f, _e1820, (_e1820 < 128f));
let _e1829 = select(0i, select(select(i32(_e1822), i32(-2147483648), (_e1822 < -2147483600f)), 2147483647i, (_e1822 > 2147483500f)), (_e1822 == _e1822));
let _e1833 = (_e1829 - select(0i, 1i, (_e1822 < f32(_e1829))));
let _e1834 = f32(_e1833);
let _e1838 = ((_e1816 - (_e1834 * 0.6933594f)) - (_e1834 * -2.1219444e-4f));
let _e1860 = -((_e1807.member_1 * _e1540));
let _e1862 = select(-87f, _e1860, (_e1860 > -87f));
let _e1864 = select(88f, _e1862, (_e1862 < 88f));
let _e1866 = ((_e1864 * 1.442695f) + 0.5f);
let _e1868 = select(-127f, _e1866, (_e1866 > -127f));
let _e1870 = select(128f, _e1868, (_e1868 < 128f));
let _e1877 = select(0i, select(select(i32(_e1870), i32(-2147483648), (_e1870 < -2147483600f)), 2147483647i, (_e1870 > 2147483500f)), (_e1870 == _e1870));
let _e1881 = (_e1877 - select(0i, 1i, (_e1870 < f32(_e1877))));
let _e1882 = f32(_e1881);
let _e1886 = ((_e1864 - (_e1882 * 0.6933594f)) - (_e1882 * -2.1219444e-4f));
let _e1908 = -((_e1807.member_2 * _e1540));
let _e1910 = select(-87f, _e1908, (_e1908 > -87f));
let _e1912 = select(88f, _e1910, (_e1910 < 88f));
let _e1914 = ((_e1912 * 1.442695f) + 0.5f);
let _e1916 = select(-127f, _e1914, (_e1914 > -127f));
let _e1918 = select(128f, _e1916, (_e1916 < 128f));
let _e1925 = select(0i, select(select(i32(_e1918), i32(-2147483648), (_e1918 < -2147483600f)), 2147483647i, (_e1918 > 2147483500f)), (_e1918 == _e1918));
let _e1929 = (_e1925 - select(0i, 1i, (_e1918 < f32(_e1925))));
let _e1930 = f32(_e1929);
let _e1934 = ((_e1912 - (_e1930 * 0.6933594f)) - (_e1930 * -2.1219444e-4f));
let _e1961 = select(0f, _e1305, (((_e1308 >= 0f) && (_e1308 < _e691)) && (_e1305 > 0f)));
if _e453 {
phi_3740_ = type_23(_e1098, _e1006);
} else {
phi_3740_ = type_23(_e1006, _e1098);
}
let _e1972 = phi_3740_;
let _e1975 = (_e1099 && (((_e1961 > 0f) && (_e1961 < _e1189)) && true));
let _e1978 = global_1.member.member_18.member;
let _e1979 = (((select(_e1124, (1f - _e1124), (_e1109 >= 0f)) - select(_e1143, (1f - _e1143), (_e1128 >= 0f))) * (1f / _e1106)) * _e1978);
let _e1983 = select(0f, (((((_e652 * _e1798.member) * ((1f + (_e1838 * (1f + (_e1838 * (0.5f + (_e1838 * (0.16666667f + (_e1838 * (0.041666668f + (_e1838 * (0.008333334f + (_e1838 * (0.001388889f + (_e1838 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1833 + 127i)) << bitcast<u32>(23i))))) * _e1795) * 1f) * _e1979), _e1975);
let _e1984 = select(0f, (((((_e665 * _e1798.member_1) * ((1f + (_e1886 * (1f + (_e1886 * (0.5f + (_e1886 * (0.16666667f + (_e1886 * (0.041666668f + (_e1886 * (0.008333334f + (_e1886 * (0.001388889f + (_e1886 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1881 + 127i)) << bitcast<u32>(23i))))) * _e1795) * 1f) * _e1979), _e1975);
let _e1985 = select(0f, (((((_e678 * _e1798.member_2) * ((1f + (_e1934 * (1f + (_e1934 * (0.5f + (_e1934 * (0.16666667f + (_e1934 * (0.041666668f + (_e1934 * (0.008333334f + (_e1934 * (0.001388889f + (_e1934 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1929 + 127i)) << bitcast<u32>(23i))))) * _e1795) * 1f) * _e1979), _e1975);
let _e1989 = (bitcast<f32>((bitcast<u32>(_e1983) & 2147483647u)) >= 1073741800f);
let _e1990 = (1f / 1048576f);
let _e1993 = ((_e1983 * select(1f, _e1990, _e1989)) + 0.5f);
let _e1995 = select(-1073741800f, _e1993, (_e1993 > -1073741800f));
let _e1997 = select(1073741800f, _e1995, (_e1995 < 1073741800f));
let _e2004 = select(0i, select(select(i32(_e1997), i32(-2147483648), (_e1997 < -2147483600f)), 2147483647i, (_e1997 > 2147483500f)), (_e1997 == _e1997));
let _e2008 = (_e2004 - select(0i, 1i, (_e1997 < f32(_e2004))));
let _e2009 = select(0i, 20i, _e1989);
let _e2013 = (bitcast<u32>(_e2008) << bitcast<u32>((_e2009 & 31i)));
let _e2020 = bitcast<u32>(((_e2008 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e2009) & 31i))));
let _e2024 = (bitcast<f32>((bitcast<u32>(_e1984) & 2147483647u)) >= 1073741800f);
let _e2027 = ((_e1984 * select(1f, _e1990, _e2024)) + 0.5f);
let _e2029 = select(-1073741800f, _e2027, (_e2027 > -1073741800f));
let _e2031 = select(1073741800f, _e2029, (_e2029 < 1073741800f));
let _e2038 = select(0i, select(select(i32(_e2031), i32(-2147483648), (_e2031 < -2147483600f)), 2147483647i, (_e2031 > 2147483500f)), (_e2031 == _e2031));
let _e2042 = (_e2038 - select(0i, 1i, (_e2031 < f32(_e2038))));
let _e2043 = select(0i, 20i, _e2024);
let _e2047 = (bitcast<u32>(_e2042) << bitcast<u32>((_e2043 & 31i)));
let _e2054 = bitcast<u32>(((_e2042 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e2043) & 31i))));
let _e2058 = (bitcast<f32>((bitcast<u32>(_e1985) & 2147483647u)) >= 1073741800f);
let _e2061 = ((_e1985 * select(1f, _e1990, _e2058)) + 0.5f);
let _e2063 = select(-1073741800f, _e2061, (_e2061 > -1073741800f));
let _e2065 = select(1073741800f, _e2063, (_e2063 < 1073741800f));
let _e2072 = select(0i, select(select(i32(_e2065), i32(-2147483648), (_e2065 < -2147483600f)), 2147483647i, (_e2065 > 2147483500f)), (_e2065 == _e2065));
let _e2076 = (_e2072 - select(0i, 1i, (_e2065 < f32(_e2072))));
let _e2077 = select(0i, 20i, _e2058);
let _e2081 = (bitcast<u32>(_e2076) << bitcast<u32>((_e2077 & 31i)));
let _e2088 = bitcast<u32>(((_e2076 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e2077) & 31i))));
let _e2093 = bitcast<i32>(bitcast<u32>((((_e1972.member_1 * _e935) + _e1972.member) * 6i)));
if ((_e2013 | _e2020) == 0u) {
} else {
let _e2096 = bitcast<u32>(_e2093);
if (_e2096 < _e270) {
let _e2100 = atomicAdd((&global_8.member[_e2096]), _e2013);
phi_3973_ = _e2100;
} else {
phi_3973_ = 0u;
}
let _e2102 = phi_3973_;
let _e2106 = (_e2020 + select(0u, 1u, ((_e2102 + _e2013) < _e2013)));
if (_e2106 == 0u) {
} else {
let _e2108 = (_e2096 + 1u);
if (_e2108 < _e270) {
let _e2112 = atomicAdd((&global_8.member[_e2108]), _e2106);
}
}
}
if ((_e2047 | _e2054) == 0u) {
} else {
let _e2116 = bitcast<u32>((_e2093 + 2i));
if (_e2116 < _e270) {
let _e2120 = atomicAdd((&global_8.member[_e2116]), _e2047);
phi_4003_ = _e2120;
} else {
phi_4003_ = 0u;
}
let _e2122 = phi_4003_;
let _e2126 = (_e2054 + select(0u, 1u, ((_e2122 + _e2047) < _e2047)));
if (_e2126 == 0u) {
} else {
let _e2128 = (_e2116 + 1u);
if (_e2128 < _e270) {
let _e2132 = atomicAdd((&global_8.member[_e2128]), _e2126);
}
}
}
if ((_e2081 | _e2088) == 0u) {
} else {
let _e2136 = bitcast<u32>((_e2093 + 4i));
if (_e2136 < _e270) {
let _e2140 = atomicAdd((&global_8.member[_e2136]), _e2081);
phi_4033_ = _e2140;
} else {
phi_4033_ = 0u;
}
let _e2142 = phi_4033_;
let _e2146 = (_e2088 + select(0u, 1u, ((_e2142 + _e2081) < _e2081)));
if (_e2146 == 0u) {
} else {
let _e2148 = (_e2136 + 1u);
if (_e2148 < _e270) {
let _e2152 = atomicAdd((&global_8.member[_e2148]), _e2146);
}
}
}
phi_2366_ = (_e1096 + 1i);
} else {
phi_2366_ = i32();
}
let _e2155 = phi_2366_;
continue;
continuing {
phi_2365_ = _e2155;
break if !(_e1099);
}
}
phi_2212_ = (_e1003 + 1i);
} else {
phi_2212_ = i32();
}
let _e2159 = phi_2212_;
continue;
continuing {
phi_2211_ = _e2159;
break if !(_e1004);
}
}
} else {
if (_e1000 == 1u) {
phi_4082_ = 0i;
loop {
let _e2163 = phi_4082_;
let _e2164 = (_e2163 < 16i);
if _e2164 {
let _e2166 = (_e980 + (_e2163 & 15i));
let _e2168 = (f32(_e2166) + 0.5f);
let _e2170 = ((_e2168 * 1f) - 0.5f);
let _e2174 = (-(((_e416 * _e2170) + _e442)) / _e429);
let _e2181 = bitcast<f32>((bitcast<u32>(((_e466 * _e2170) + ((_e479 * _e2174) + _e492))) & 2147483647u));
let _e2188 = bitcast<f32>((bitcast<u32>(((_e505 * _e2170) + ((_e518 * _e2174) + _e531))) & 2147483647u));
let _e2192 = (((0.5f * (_e2181 + _e2188)) / _e534) + _e717);
let _e2193 = (1f / 1f);
let _e2201 = ((((_e2174 + _e2192) + 0.5f) * _e2193) - 0.5f);
let _e2202 = f32(_e985);
let _e2203 = (0f - 1f);
let _e2205 = select(_e2203, _e2201, (_e2201 > _e2203));
let _e2207 = select(_e2202, _e2205, (_e2205 < _e2202));
let _e2214 = select(0i, select(select(i32(_e2207), i32(-2147483648), (_e2207 < -2147483600f)), 2147483647i, (_e2207 > 2147483500f)), (_e2207 == _e2207));
let _e2219 = (((((_e2174 - _e2192) + 0.5f) * _e2193) - 0.5f) + 1f);
let _e2220 = (_e2202 + 1f);
let _e2222 = select(0f, _e2219, (_e2219 > 0f));
let _e2224 = select(_e2220, _e2222, (_e2222 < _e2220));
let _e2231 = select(0i, select(select(i32(_e2224), i32(-2147483648), (_e2224 < -2147483600f)), 2147483647i, (_e2224 > 2147483500f)), (_e2224 == _e2224));
let _e2242 = ((1e-4f * 1f) * _e534);
let _e2244 = select(_e2188, _e2181, (_e2181 > _e2188));
let _e2246 = select(_e2242, _e2244, (_e2244 > _e2242));
let _e2248 = select(_e2188, _e2181, (_e2181 < _e2188));
let _e2250 = select(_e2242, _e2248, (_e2248 > _e2242));
let _e2252 = (0.5f * (_e2246 + _e2250));
let _e2253 = (0.5f / _e2250);
let _e2254 = (1f / _e2246);
phi_4236_ = 0i;
loop {
let _e2256 = phi_4236_;
let _e2258 = (((_e2231 - select(0i, 1i, (_e2224 < f32(_e2231)))) + (_e2163 >> bitcast<u32>(4u))) + bitcast<i32>(_e2256));
let _e2259 = (_e2258 <= select(-1i, (_e2214 - select(0i, 1i, (_e2207 < f32(_e2214)))), (_e2166 <= _e984)));
if _e2259 {
let _e2261 = (f32(_e2258) + 0.5f);
let _e2265 = ((((_e2261 * 1f) - 0.5f) - _e2174) * _e534);
let _e2266 = (_e534 * 1f);
let _e2268 = (0.5f * _e2266);
let _e2269 = (_e2265 + _e2268);
let _e2270 = -(_e2269);
let _e2273 = (_e2252 - select(_e2270, _e2269, (_e2269 > _e2270)));
let _e2275 = select(0f, _e2273, (_e2273 > 0f));
let _e2277 = select(_e2250, _e2275, (_e2275 < _e2250));
let _e2280 = (_e2273 - _e2250);
let _e2284 = (((_e2277 * (_e2277 * _e2253)) + select(0f, _e2280, (_e2280 > 0f))) * _e2254);
let _e2288 = (_e2265 - _e2268);
let _e2289 = -(_e2288);
let _e2292 = (_e2252 - select(_e2289, _e2288, (_e2288 > _e2289)));
let _e2294 = select(0f, _e2292, (_e2292 > 0f));
let _e2296 = select(_e2250, _e2294, (_e2294 < _e2250));
let _e2299 = (_e2292 - _e2250);
let _e2303 = (((_e2296 * (_e2296 * _e2253)) + select(0f, _e2299, (_e2299 > 0f))) * _e2254);
if _e453 {
phi_4341_ = type_23(_e2258, _e2166);
} else {
phi_4341_ = type_23(_e2166, _e2258);
}
let _e2312 = phi_4341_;
let _e2316 = bitcast<i32>((_e931 * _e934));
local_204 = _e2316;
local_205 = ((_e2312.member_1 * _e935) + _e2312.member);
let _e2319 = local_204;
let _e2320 = local_205;
let _e2321 = (_e2319 + _e2320);
let _e2323 = (bitcast<i32>(_e259) - 1i);
let _e2325 = select(_e2323, _e2321, (_e2321 < _e2323));
let _e2330 = global_5.member[bitcast<u32>(select(0i, _e2325, (_e2325 > 0i)))];
let _e2331 = local_204;
let _e2333 = local_205;
let _e2334 = ((2i * _e2331) + _e2333);
let _e2336 = select(_e2323, _e2334, (_e2334 < _e2323));
let _e2341 = global_5.member[bitcast<u32>(select(0i, _e2336, (_e2336 > 0i)))];
let _e2342 = local_205;
let _e2344 = select(_e2323, _e2342, (_e2342 < _e2323));
let _e2349 = global_5.member[bitcast<u32>(select(0i, _e2344, (_e2344 > 0i)))];
let _e2350 = local_205;
let _e2353 = f32(_e935);
let _e2354 = f32(_e936);
let _e2361 = global_1.member.member_2.member;
let _e2362 = (((((f32(_e2312.member) + 0.5f) / _e2353) * 2f) - 1f) * _e2361);
let _e2369 = global_1.member.member_2.member_1;
let _e2370 = ((1f - (((f32(_e2312.member_1) + 0.5f) / _e2354) * 2f)) * _e2369);
let _e2372 = global_1.member.member_3;
let _e2380 = global_1.member.member_4;
let _e2387 = ((_e2372.member * _e2362) + (_e2380.member * _e2370));
let _e2388 = ((_e2372.member_1 * _e2362) + (_e2380.member_1 * _e2370));
let _e2389 = ((_e2372.member_2 * _e2362) + (_e2380.member_2 * _e2370));
let _e2392 = global_1.member.member_2.member_3;
let _e2393 = (_e2392 != 0u);
let _e2395 = global_1.member.member_5;
let _e2402 = select((_e2395.member + _e2387), _e2395.member, _e2393);
let _e2403 = select((_e2395.member_1 + _e2388), _e2395.member_1, _e2393);
let _e2404 = select((_e2395.member_2 + _e2389), _e2395.member_2, _e2393);
let _e2406 = global_1.member.member_6;
let _e2413 = select(_e2406.member, (_e2406.member + _e2387), _e2393);
let _e2414 = select(_e2406.member_1, (_e2406.member_1 + _e2388), _e2393);
let _e2415 = select(_e2406.member_2, (_e2406.member_2 + _e2389), _e2393);
let _e2420 = (((_e2402 * _e2402) + (_e2403 * _e2403)) + (_e2404 * _e2404));
let _e2423 = sqrt(select(0f, _e2420, (_e2420 > 0f)));
let _e2424 = (1f / _e2423);
let _e2425 = (_e2402 * _e2424);
let _e2426 = (_e2403 * _e2424);
let _e2427 = (_e2404 * _e2424);
let _e2428 = (_e575 - _e2413);
let _e2429 = (_e587 - _e2414);
let _e2430 = (_e600 - _e2415);
let _e2435 = (((_e2428 * _e2425) + (_e2429 * _e2426)) + (_e2430 * _e2427));
let _e2440 = (((_e2428 * _e613) + (_e2429 * _e626)) + (_e2430 * _e639));
let _e2445 = (((_e2425 * _e613) + (_e2426 * _e626)) + (_e2427 * _e639));
let _e2448 = ((_e2426 * _e639) - (_e2427 * _e626));
let _e2451 = ((_e2427 * _e613) - (_e2425 * _e639));
let _e2454 = ((_e2425 * _e626) - (_e2426 * _e613));
let _e2459 = (((_e2448 * _e2448) + (_e2451 * _e2451)) + (_e2454 * _e2454));
let _e2462 = (1f / select(1e-9f, _e2459, (_e2459 > 1e-9f)));
let _e2465 = ((_e2435 - (_e2445 * _e2440)) * _e2462);
let _e2468 = (((_e2445 * _e2435) - _e2440) * _e2462);
let _e2474 = -(_e2445);
let _e2477 = global_1.member.member_13.member_2;
let _e2478 = (_e2477 * _e2477);
let _e2482 = ((1f + _e2478) - ((2f * _e2477) * _e2474));
let _e2484 = select(1e-9f, _e2482, (_e2482 > 1e-9f));
let _e2496 = global_1.member.member_13.member_3;
if (_e2496 == 2u) {
let _e2501 = (0.5f - (0.5f * _e2474));
let _e2503 = select(0f, _e2501, (_e2501 > 0f));
let _e2507 = (sqrt(select(0f, _e2503, (_e2503 > 0f))) * 255f);
let _e2508 = (255f - 1f);
let _e2510 = select(0f, _e2507, (_e2507 > 0f));
let _e2512 = select(_e2508, _e2510, (_e2510 < _e2508));
let _e2519 = select(0i, select(select(i32(_e2512), i32(-2147483648), (_e2512 < -2147483600f)), 2147483647i, (_e2512 > 2147483500f)), (_e2512 == _e2512));
let _e2523 = (_e2519 - select(0i, 1i, (_e2512 < f32(_e2519))));
let _e2526 = global_1.member.member_13.member_11;
let _e2527 = bitcast<i32>(_e2526);
let _e2528 = (_e2527 + _e2523);
let _e2530 = (bitcast<i32>(_e265) - 1i);
let _e2532 = select(_e2530, _e2528, (_e2528 < _e2530));
let _e2537 = global_2.member[bitcast<u32>(select(0i, _e2532, (_e2532 > 0i)))];
let _e2539 = (_e2527 + (_e2523 + 1i));
let _e2541 = select(_e2530, _e2539, (_e2539 < _e2530));
let _e2546 = global_2.member[bitcast<u32>(select(0i, _e2541, (_e2541 > 0i)))];
phi_4768_ = (_e2537 + ((_e2546 - _e2537) * (_e2507 - f32(_e2523))));
} else {
phi_4768_ = select(((1f - _e2478) / (_e2484 * sqrt(select(0f, _e2484, (_e2484 > 0f))))), (0.75f * (1f + (_e2474 * _e2474))), (_e2496 == 1u));
}
let _e2553 = phi_4768_;
let _e2559 = global_1.member.member_12.member_11;
let _e2562 = global_1.member.member_12.member_4;
let _e2565 = global_1.member.member_12.member_12;
let _e2571 = global_1.member.member.member;
let _e2573 = (_e2468 / _e691);
local_201 = bitcast<i32>((_e2559 + (_e2562 * _e2565)));
local_202 = _e281;
local_203 = bitcast<i32>(_e2571);
let _e2576 = global_1.member.member_13.member_6;
let _e2577 = f32(_e2576);
let _e2579 = select(0f, _e2573, (_e2573 > 0f));
let _e2582 = (select(1f, _e2579, (_e2579 < 1f)) * _e2577);
let _e2583 = (_e2577 - 1f);
let _e2585 = select(0f, _e2583, (_e2583 > 0f));
let _e2587 = select(0f, _e2582, (_e2582 > 0f));
let _e2589 = select(_e2585, _e2587, (_e2587 < _e2585));
let _e2596 = select(0i, select(select(i32(_e2589), i32(-2147483648), (_e2589 < -2147483600f)), 2147483647i, (_e2589 > 2147483500f)), (_e2589 == _e2589));
let _e2600 = (_e2596 - select(0i, 1i, (_e2589 < f32(_e2596))));
if (_e2600 > 0i) {
let _e2603 = local_201;
let _e2604 = local_203;
let _e2607 = local_202;
let _e2608 = ((_e2603 + ((_e2600 - 1i) * _e2604)) + _e2607);
let _e2610 = (bitcast<i32>(_e268) - 1i);
let _e2612 = select(_e2610, _e2608, (_e2608 < _e2610));
let _e2617 = global_7.member[bitcast<u32>(select(0i, _e2612, (_e2612 > 0i)))];
phi_4874_ = _e2617;
} else {
phi_4874_ = 0f;
}
let _e2619 = phi_4874_;
let _e2620 = local_201;
let _e2621 = local_203;
let _e2624 = local_202;
let _e2625 = ((_e2620 + (_e2600 * _e2621)) + _e2624);
let _e2627 = (bitcast<i32>(_e268) - 1i);
let _e2629 = select(_e2627, _e2625, (_e2625 < _e2627));
let _e2634 = global_7.member[bitcast<u32>(select(0i, _e2629, (_e2629 > 0i)))];
let _e2641 = (_e2341 - _e2330);
let _e2644 = ((_e2465 - _e2330) / select(1e-9f, _e2641, (_e2641 > 1e-9f)));
local_198 = 0i;
local_199 = _e2350;
local_200 = _e2316;
let _e2646 = select(0f, _e2644, (_e2644 > 0f));
let _e2649 = (select(1f, _e2646, (_e2646 < 1f)) * _e2577);
let _e2651 = select(0f, _e2649, (_e2649 > 0f));
let _e2653 = select(_e2585, _e2651, (_e2651 < _e2585));
let _e2660 = select(0i, select(select(i32(_e2653), i32(-2147483648), (_e2653 < -2147483600f)), 2147483647i, (_e2653 > 2147483500f)), (_e2653 == _e2653));
let _e2664 = (_e2660 - select(0i, 1i, (_e2653 < f32(_e2660))));
if (_e2664 > 0i) {
let _e2667 = local_198;
let _e2668 = local_200;
let _e2671 = local_199;
let _e2672 = ((_e2667 + ((_e2664 - 1i) * _e2668)) + _e2671);
let _e2674 = select(_e2627, _e2672, (_e2672 < _e2627));
let _e2679 = global_7.member[bitcast<u32>(select(0i, _e2674, (_e2674 > 0i)))];
phi_5001_ = _e2679;
} else {
phi_5001_ = 0f;
}
let _e2681 = phi_5001_;
let _e2682 = local_198;
let _e2683 = local_200;
let _e2686 = local_199;
let _e2687 = ((_e2682 + (_e2664 * _e2683)) + _e2686);
let _e2689 = select(_e2627, _e2687, (_e2687 < _e2627));
let _e2694 = global_7.member[bitcast<u32>(select(0i, _e2689, (_e2689 > 0i)))];
let _e2700 = ((_e2619 + ((_e2634 - _e2619) * (_e2582 - f32(_e2600)))) + (_e2681 + ((_e2694 - _e2681) * (_e2649 - f32(_e2664)))));
let _e2709 = global_1.member.member_13.member_7;
let _e2710 = bitcast<i32>(_e2709);
let _e2713 = global_1.member.member_13.member_8;
let _e2714 = bitcast<i32>(_e2713);
let _e2717 = global_1.member.member_13.member_9;
let _e2718 = bitcast<i32>(_e2717);
let _e2721 = global_1.member.member_13.member_4;
let _e2727 = global_1.member.member_13.member_5;
let _e2731 = f32(_e2710);
let _e2736 = (((((_e2413 + (_e2425 * _e2465)) - _e2721.member) / (_e2727.member - _e2721.member)) * _e2731) - 0.5f);
let _e2737 = (_e2731 - 1f);
let _e2739 = select(0f, _e2736, (_e2736 > 0f));
let _e2741 = select(_e2737, _e2739, (_e2739 < _e2737));
let _e2742 = f32(_e2714);
let _e2747 = (((((_e2414 + (_e2426 * _e2465)) - _e2721.member_1) / (_e2727.member_1 - _e2721.member_1)) * _e2742) - 0.5f);
let _e2748 = (_e2742 - 1f);
let _e2750 = select(0f, _e2747, (_e2747 > 0f));
let _e2752 = select(_e2748, _e2750, (_e2750 < _e2748));
let _e2753 = f32(_e2718);
let _e2758 = (((((_e2415 + (_e2427 * _e2465)) - _e2721.member_2) / (_e2727.member_2 - _e2721.member_2)) * _e2753) - 0.5f);
let _e2759 = (_e2753 - 1f);
let _e2761 = select(0f, _e2758, (_e2758 > 0f));
let _e2763 = select(_e2759, _e2761, (_e2761 < _e2759));
let _e2765 = select(0f, _e2741, (_e2741 > 0f));
let _e2767 = select(1e6f, _e2765, (_e2765 < 1e6f));
let _e2774 = select(0i, select(select(i32(_e2767), i32(-2147483648), (_e2767 < -2147483600f)), 2147483647i, (_e2767 > 2147483500f)), (_e2767 == _e2767));
let _e2778 = (_e2774 - select(0i, 1i, (_e2767 < f32(_e2774))));
let _e2780 = select(0f, _e2752, (_e2752 > 0f));
let _e2782 = select(1e6f, _e2780, (_e2780 < 1e6f));
let _e2789 = select(0i, select(select(i32(_e2782), i32(-2147483648), (_e2782 < -2147483600f)), 2147483647i, (_e2782 > 2147483500f)), (_e2782 == _e2782));
let _e2793 = (_e2789 - select(0i, 1i, (_e2782 < f32(_e2789))));
let _e2795 = select(0f, _e2763, (_e2763 > 0f));
let _e2797 = select(1e6f, _e2795, (_e2795 < 1e6f));
let _e2804 = select(0i, select(select(i32(_e2797), i32(-2147483648), (_e2797 < -2147483600f)), 2147483647i, (_e2797 > 2147483500f)), (_e2797 == _e2797));
let _e2808 = (_e2804 - select(0i, 1i, (_e2797 < f32(_e2804))));
let _e2812 = (_e2752 - f32(_e2793));
let _e2814 = (_e2763 - f32(_e2808));
local_196 = (_e2741 - f32(_e2778));
let _e2815 = (_e2778 + 1i);
let _e2817 = select(_e2815, 0i, (_e2815 < 0i));
if (_e2817 >= _e2710) {
phi_5149_ = (_e2710 - 1i);
} else {
phi_5149_ = _e2817;
}
let _e2821 = phi_5149_;
local_197 = (_e2821 - _e2778);
let _e2823 = (_e2793 + 1i);
let _e2825 = select(_e2823, 0i, (_e2823 < 0i));
if (_e2825 >= _e2714) {
phi_5162_ = (_e2714 - 1i);
} else {
phi_5162_ = _e2825;
}
let _e2829 = phi_5162_;
let _e2831 = ((_e2829 - _e2793) * _e2710);
let _e2832 = (_e2808 + 1i);
let _e2834 = select(_e2832, 0i, (_e2832 < 0i));
if (_e2834 >= _e2718) {
phi_5176_ = (_e2718 - 1i);
} else {
phi_5176_ = _e2834;
}
let _e2838 = phi_5176_;
let _e2844 = global_1.member.member_13.member_10;
let _e2850 = ((bitcast<i32>(_e2844) + (((_e2808 * _e2714) + _e2793) * _e2710)) + _e2778);
let _e2852 = (bitcast<i32>(_e265) - 1i);
let _e2854 = select(_e2852, _e2850, (_e2850 < _e2852));
let _e2859 = global_2.member[bitcast<u32>(select(0i, _e2854, (_e2854 > 0i)))];
let _e2860 = local_196;
let _e2863 = local_197;
let _e2864 = (_e2850 + _e2863);
let _e2866 = select(_e2852, _e2864, (_e2864 < _e2852));
let _e2871 = global_2.member[bitcast<u32>(select(0i, _e2866, (_e2866 > 0i)))];
let _e2872 = local_196;
let _e2875 = (1f - _e2812);
let _e2877 = (_e2850 + _e2831);
let _e2879 = select(_e2852, _e2877, (_e2877 < _e2852));
let _e2884 = global_2.member[bitcast<u32>(select(0i, _e2879, (_e2879 > 0i)))];
let _e2885 = local_196;
let _e2888 = local_197;
let _e2889 = (_e2877 + _e2888);
let _e2891 = select(_e2852, _e2889, (_e2889 < _e2852));
let _e2896 = global_2.member[bitcast<u32>(select(0i, _e2891, (_e2891 > 0i)))];
let _e2897 = local_196;
let _e2902 = (_e2850 + (((_e2838 - _e2808) * _e2710) * _e2714));
let _e2904 = select(_e2852, _e2902, (_e2902 < _e2852));
let _e2909 = global_2.member[bitcast<u32>(select(0i, _e2904, (_e2904 > 0i)))];
let _e2910 = local_196;
let _e2913 = local_197;
let _e2914 = (_e2902 + _e2913);
let _e2916 = select(_e2852, _e2914, (_e2914 < _e2852));
let _e2921 = global_2.member[bitcast<u32>(select(0i, _e2916, (_e2916 > 0i)))];
let _e2922 = local_196;
let _e2926 = (_e2902 + _e2831);
let _e2928 = select(_e2852, _e2926, (_e2926 < _e2852));
let _e2933 = global_2.member[bitcast<u32>(select(0i, _e2928, (_e2928 > 0i)))];
let _e2934 = local_196;
let _e2937 = local_197;
let _e2938 = (_e2926 + _e2937);
let _e2940 = select(_e2852, _e2938, (_e2938 < _e2852));
let _e2945 = global_2.member[bitcast<u32>(select(0i, _e2940, (_e2940 > 0i)))];
let _e2946 = local_196;
let _e2955 = ((_e2423 * (_e2553 * (0.25f / 3.1415927f))) * ((((((_e2859 * (1f - _e2860)) + (_e2871 * _e2872)) * _e2875) + (((_e2884 * (1f - _e2885)) + (_e2896 * _e2897)) * _e2812)) * (1f - _e2814)) + (((((_e2909 * (1f - _e2910)) + (_e2921 * _e2922)) * _e2875) + (((_e2933 * (1f - _e2934)) + (_e2945 * _e2946)) * _e2812)) * _e2814)));
let _e2958 = global_1.member.member_13.member_1;
let _e2967 = global_1.member.member_13.member;
let _e2972 = -((_e2967.member * _e2700));
let _e2974 = select(-87f, _e2972, (_e2972 > -87f));
let _e2976 = select(88f, _e2974, (_e2974 < 88f));
let _e2978 = ((_e2976 * 1.442695f) + 0.5f);
let _e2980 = select(-127f, _e2978, (_e2978 > -127f));
let _e2982 = select(128f, _e2980, (_e2980 < 128f));
let _e2989 = select(0i, select(select(i32(_e2982), i32(-2147483648), (_e2982 < -2147483600f)), 2147483647i, (_e2982 > 2147483500f)), (_e2982 == _e2982));
let _e2993 = (_e2989 - select(0i, 1i, (_e2982 < f32(_e2989))));
let _e2994 = f32(_e2993);
let _e2998 = ((_e2976 - (_e2994 * 0.6933594f)) - (_e2994 * -2.1219444e-4f));
let _e3020 = -((_e2967.member_1 * _e2700));
let _e3022 = select(-87f, _e3020, (_e3020 > -87f));
let _e3024 = select(88f, _e3022, (_e3022 < 88f));
let _e3026 = ((_e3024 * 1.442695f) + 0.5f);
let _e3028 = select(-127f, _e3026, (_e3026 > -127f));
let _e3030 = select(128f, _e3028, (_e3028 < 128f));
let _e3037 = select(0i, select(select(i32(_e3030), i32(-2147483648), (_e3030 < -2147483600f)), 2147483647i, (_e3030 > 2147483500f)), (_e3030 == _e3030));
let _e3041 = (_e3037 - select(0i, 1i, (_e3030 < f32(_e3037))));
let _e3042 = f32(_e3041);
let _e3046 = ((_e3024 - (_e3042 * 0.6933594f)) - (_e3042 * -2.1219444e-4f));
let _e3068 = -((_e2967.member_2 * _e2700));
let _e3070 = select(-87f, _e3068, (_e3068 > -87f));
let _e3072 = select(88f, _e3070, (_e3070 < 88f));
let _e3074 = ((_e3072 * 1.442695f) + 0.5f);
let _e3076 = select(-127f, _e3074, (_e3074 > -127f));
let _e3078 = select(128f, _e3076, (_e3076 < 128f));
let _e3085 = select(0i, select(select(i32(_e3078), i32(-2147483648), (_e3078 < -2147483600f)), 2147483647i, (_e3078 > 2147483500f)), (_e3078 == _e3078));
let _e3089 = (_e3085 - select(0i, 1i, (_e3078 < f32(_e3085))));
let _e3090 = f32(_e3089);
let _e3094 = ((_e3072 - (_e3090 * 0.6933594f)) - (_e3090 * -2.1219444e-4f));
let _e3121 = select(0f, _e2465, (((_e2468 >= 0f) && (_e2468 < _e691)) && (_e2465 > 0f)));
let _e3123 = ((_e766 + _e988) + _e992);
let _e3124 = (_e3123 & 31u);
let _e3126 = (1u << bitcast<u32>(_e3124));
let _e3135 = bitcast<i32>((((_e931 + _e3126) - 1u) >> bitcast<u32>(_e3124)));
let _e3136 = bitcast<i32>((((_e934 + _e3126) - 1u) >> bitcast<u32>(_e3124)));
if _e453 {
phi_5637_ = type_23(_e3136, _e3135);
} else {
phi_5637_ = type_23(_e3135, _e3136);
}
let _e3140 = phi_5637_;
let _e3145 = f32((1i << bitcast<u32>(_e3124)));
let _e3146 = (1f / _e3145);
let _e3148 = ((_e2168 * _e3146) - 0.5f);
let _e3150 = ((_e2261 * _e3146) - 0.5f);
let _e3152 = select(-1f, _e3148, (_e3148 > -1f));
let _e3154 = select(1e6f, _e3152, (_e3152 < 1e6f));
let _e3161 = select(0i, select(select(i32(_e3154), i32(-2147483648), (_e3154 < -2147483600f)), 2147483647i, (_e3154 > 2147483500f)), (_e3154 == _e3154));
let _e3165 = (_e3161 - select(0i, 1i, (_e3154 < f32(_e3161))));
let _e3167 = select(-1f, _e3150, (_e3150 > -1f));
let _e3169 = select(1e6f, _e3167, (_e3167 < 1e6f));
let _e3176 = select(0i, select(select(i32(_e3169), i32(-2147483648), (_e3169 < -2147483600f)), 2147483647i, (_e3169 > 2147483500f)), (_e3169 == _e3169));
let _e3180 = (_e3176 - select(0i, 1i, (_e3169 < f32(_e3176))));
let _e3182 = (_e3148 - f32(_e3165));
let _e3184 = (_e3150 - f32(_e3180));
let _e3185 = (1f - _e3182);
let _e3186 = (1f - _e3184);
let _e3189 = select(_e3165, 0i, (_e3165 < 0i));
let _e3190 = (_e3189 >= _e3140.member);
if _e3190 {
phi_5715_ = (_e3140.member - 1i);
} else {
phi_5715_ = _e3189;
}
let _e3193 = phi_5715_;
let _e3195 = select(_e3180, 0i, (_e3180 < 0i));
let _e3196 = (_e3195 >= _e3140.member_1);
if _e3196 {
phi_5726_ = (_e3140.member_1 - 1i);
} else {
phi_5726_ = _e3195;
}
let _e3199 = phi_5726_;
let _e3203 = (((f32(_e3193) + 0.5f) * _e3145) - 0.5f);
let _e3207 = (((f32(_e3199) + 0.5f) * _e3145) - 0.5f);
if _e453 {
phi_5754_ = type_23(_e3199, _e3193);
} else {
phi_5754_ = type_23(_e3193, _e3199);
}
let _e3213 = phi_5754_;
let _e3219 = bitcast<i32>(((_e931 + 1u) >> bitcast<u32>(1u)));
let _e3222 = global_1.member.member_18.member_6;
let _e3225 = global_1.member.member_18.member_7;
let _e3228 = global_1.member.member_18.member_8;
let _e3229 = (_e3123 == 0u);
if _e3229 {
phi_5805_ = 0u;
} else {
if (_e3123 == 1u) {
phi_5804_ = 0u;
} else {
if (_e3123 == 2u) {
phi_5803_ = _e3222;
} else {
phi_5803_ = select(_e3228, _e3225, (_e3123 == 3u));
}
let _e3235 = phi_5803_;
phi_5804_ = _e3235;
}
let _e3237 = phi_5804_;
phi_5805_ = _e3237;
}
let _e3239 = phi_5805_;
local_194 = (((bitcast<i32>(_e3239) + _e3213.member_1) * _e3219) + _e3213.member);
let _e3244 = local_194;
let _e3246 = (bitcast<i32>(_e262) - 1i);
let _e3248 = select(_e3246, _e3244, (_e3244 < _e3246));
let _e3253 = global_6.member[bitcast<u32>(select(0i, _e3248, (_e3248 > 0i)))];
let _e3258 = (((((select(_e3203, _e3207, _e453) + 0.5f) / _e2353) * 2f) - 1f) * _e2361);
let _e3263 = ((1f - (((select(_e3207, _e3203, _e453) + 0.5f) / _e2354) * 2f)) * _e2369);
let _e3270 = ((_e2372.member * _e3258) + (_e2380.member * _e3263));
let _e3271 = ((_e2372.member_1 * _e3258) + (_e2380.member_1 * _e3263));
let _e3272 = ((_e2372.member_2 * _e3258) + (_e2380.member_2 * _e3263));
let _e3276 = select((_e2395.member + _e3270), _e2395.member, _e2393);
let _e3277 = select((_e2395.member_1 + _e3271), _e2395.member_1, _e2393);
let _e3278 = select((_e2395.member_2 + _e3272), _e2395.member_2, _e2393);
let _e3289 = (((_e3276 * _e3276) + (_e3277 * _e3277)) + (_e3278 * _e3278));
let _e3293 = (1f / sqrt(select(0f, _e3289, (_e3289 > 0f))));
let _e3294 = (_e3276 * _e3293);
let _e3295 = (_e3277 * _e3293);
let _e3296 = (_e3278 * _e3293);
let _e3297 = (_e575 - select(_e2406.member, (_e2406.member + _e3270), _e2393));
let _e3298 = (_e587 - select(_e2406.member_1, (_e2406.member_1 + _e3271), _e2393));
let _e3299 = (_e600 - select(_e2406.member_2, (_e2406.member_2 + _e3272), _e2393));
let _e3304 = (((_e3297 * _e3294) + (_e3298 * _e3295)) + (_e3299 * _e3296));
let _e3309 = (((_e3297 * _e613) + (_e3298 * _e626)) + (_e3299 * _e639));
let _e3314 = (((_e3294 * _e613) + (_e3295 * _e626)) + (_e3296 * _e639));
let _e3317 = ((_e3295 * _e639) - (_e3296 * _e626));
let _e3320 = ((_e3296 * _e613) - (_e3294 * _e639));
let _e3323 = ((_e3294 * _e626) - (_e3295 * _e613));
let _e3328 = (((_e3317 * _e3317) + (_e3320 * _e3320)) + (_e3323 * _e3323));
let _e3331 = (1f / select(1e-9f, _e3328, (_e3328 > 1e-9f)));
let _e3334 = ((_e3304 - (_e3314 * _e3309)) * _e3331);
let _e3337 = (((_e3314 * _e3304) - _e3309) * _e3331);
let _e3343 = select(0f, _e3334, (((_e3337 >= 0f) && (_e3337 < _e691)) && (_e3334 > 0f)));
let _e3345 = (_e3193 << bitcast<u32>(_e3124));
let _e3357 = (_e3165 + 1i);
let _e3360 = select(_e3357, 0i, (_e3357 < 0i));
let _e3361 = (_e3360 >= _e3140.member);
if _e3361 {
phi_6466_ = (_e3140.member - 1i);
} else {
phi_6466_ = _e3360;
}
let _e3364 = phi_6466_;
if _e3196 {
phi_6477_ = (_e3140.member_1 - 1i);
} else {
phi_6477_ = _e3195;
}
let _e3367 = phi_6477_;
let _e3371 = (((f32(_e3364) + 0.5f) * _e3145) - 0.5f);
let _e3375 = (((f32(_e3367) + 0.5f) * _e3145) - 0.5f);
if _e453 {
phi_6505_ = type_23(_e3367, _e3364);
} else {
phi_6505_ = type_23(_e3364, _e3367);
}
let _e3381 = phi_6505_;
if _e3229 {
phi_6556_ = 0u;
} else {
if (_e3123 == 1u) {
phi_6555_ = 0u;
} else {
if (_e3123 == 2u) {
phi_6554_ = _e3222;
} else {
phi_6554_ = select(_e3228, _e3225, (_e3123 == 3u));
}
let _e3389 = phi_6554_;
phi_6555_ = _e3389;
}
let _e3391 = phi_6555_;
phi_6556_ = _e3391;
}
let _e3393 = phi_6556_;
local_192 = (((bitcast<i32>(_e3393) + _e3381.member_1) * _e3219) + _e3381.member);
let _e3398 = local_192;
let _e3400 = select(_e3246, _e3398, (_e3398 < _e3246));
let _e3405 = global_6.member[bitcast<u32>(select(0i, _e3400, (_e3400 > 0i)))];
let _e3410 = (((((select(_e3371, _e3375, _e453) + 0.5f) / _e2353) * 2f) - 1f) * _e2361);
let _e3415 = ((1f - (((select(_e3375, _e3371, _e453) + 0.5f) / _e2354) * 2f)) * _e2369);
let _e3422 = ((_e2372.member * _e3410) + (_e2380.member * _e3415));
let _e3423 = ((_e2372.member_1 * _e3410) + (_e2380.member_1 * _e3415));
let _e3424 = ((_e2372.member_2 * _e3410) + (_e2380.member_2 * _e3415));
let _e3428 = select((_e2395.member + _e3422), _e2395.member, _e2393);
let _e3429 = select((_e2395.member_1 + _e3423), _e2395.member_1, _e2393);
let _e3430 = select((_e2395.member_2 + _e3424), _e2395.member_2, _e2393);
let _e3441 = (((_e3428 * _e3428) + (_e3429 * _e3429)) + (_e3430 * _e3430));
let _e3445 = (1f / sqrt(select(0f, _e3441, (_e3441 > 0f))));
let _e3446 = (_e3428 * _e3445);
let _e3447 = (_e3429 * _e3445);
let _e3448 = (_e3430 * _e3445);
let _e3449 = (_e575 - select(_e2406.member, (_e2406.member + _e3422), _e2393));
let _e3450 = (_e587 - select(_e2406.member_1, (_e2406.member_1 + _e3423), _e2393));
let _e3451 = (_e600 - select(_e2406.member_2, (_e2406.member_2 + _e3424), _e2393));
let _e3456 = (((_e3449 * _e3446) + (_e3450 * _e3447)) + (_e3451 * _e3448));
let _e3461 = (((_e3449 * _e613) + (_e3450 * _e626)) + (_e3451 * _e639));
let _e3466 = (((_e3446 * _e613) + (_e3447 * _e626)) + (_e3448 * _e639));
let _e3469 = ((_e3447 * _e639) - (_e3448 * _e626));
let _e3472 = ((_e3448 * _e613) - (_e3446 * _e639));
let _e3475 = ((_e3446 * _e626) - (_e3447 * _e613));
let _e3480 = (((_e3469 * _e3469) + (_e3472 * _e3472)) + (_e3475 * _e3475));
let _e3483 = (1f / select(1e-9f, _e3480, (_e3480 > 1e-9f)));
let _e3486 = ((_e3456 - (_e3466 * _e3461)) * _e3483);
let _e3489 = (((_e3466 * _e3456) - _e3461) * _e3483);
let _e3495 = select(0f, _e3486, (((_e3489 >= 0f) && (_e3489 < _e691)) && (_e3486 > 0f)));
let _e3497 = (_e3364 << bitcast<u32>(_e3124));
let _e3509 = (_e3180 + 1i);
if _e3190 {
phi_7217_ = (_e3140.member - 1i);
} else {
phi_7217_ = _e3189;
}
let _e3513 = phi_7217_;
let _e3515 = select(_e3509, 0i, (_e3509 < 0i));
let _e3516 = (_e3515 >= _e3140.member_1);
if _e3516 {
phi_7228_ = (_e3140.member_1 - 1i);
} else {
phi_7228_ = _e3515;
}
let _e3519 = phi_7228_;
let _e3523 = (((f32(_e3513) + 0.5f) * _e3145) - 0.5f);
let _e3527 = (((f32(_e3519) + 0.5f) * _e3145) - 0.5f);
if _e453 {
phi_7256_ = type_23(_e3519, _e3513);
} else {
phi_7256_ = type_23(_e3513, _e3519);
}
let _e3533 = phi_7256_;
if _e3229 {
phi_7307_ = 0u;
} else {
if (_e3123 == 1u) {
phi_7306_ = 0u;
} else {
if (_e3123 == 2u) {
phi_7305_ = _e3222;
} else {
phi_7305_ = select(_e3228, _e3225, (_e3123 == 3u));
}
let _e3541 = phi_7305_;
phi_7306_ = _e3541;
}
let _e3543 = phi_7306_;
phi_7307_ = _e3543;
}
let _e3545 = phi_7307_;
local_190 = (((bitcast<i32>(_e3545) + _e3533.member_1) * _e3219) + _e3533.member);
let _e3550 = local_190;
let _e3552 = select(_e3246, _e3550, (_e3550 < _e3246));
let _e3557 = global_6.member[bitcast<u32>(select(0i, _e3552, (_e3552 > 0i)))];
let _e3562 = (((((select(_e3523, _e3527, _e453) + 0.5f) / _e2353) * 2f) - 1f) * _e2361);
let _e3567 = ((1f - (((select(_e3527, _e3523, _e453) + 0.5f) / _e2354) * 2f)) * _e2369);
let _e3574 = ((_e2372.member * _e3562) + (_e2380.member * _e3567));
let _e3575 = ((_e2372.member_1 * _e3562) + (_e2380.member_1 * _e3567));
let _e3576 = ((_e2372.member_2 * _e3562) + (_e2380.member_2 * _e3567));
let _e3580 = select((_e2395.member + _e3574), _e2395.member, _e2393);
let _e3581 = select((_e2395.member_1 + _e3575), _e2395.member_1, _e2393);
let _e3582 = select((_e2395.member_2 + _e3576), _e2395.member_2, _e2393);
let _e3593 = (((_e3580 * _e3580) + (_e3581 * _e3581)) + (_e3582 * _e3582));
let _e3597 = (1f / sqrt(select(0f, _e3593, (_e3593 > 0f))));
let _e3598 = (_e3580 * _e3597);
let _e3599 = (_e3581 * _e3597);
let _e3600 = (_e3582 * _e3597);
let _e3601 = (_e575 - select(_e2406.member, (_e2406.member + _e3574), _e2393));
let _e3602 = (_e587 - select(_e2406.member_1, (_e2406.member_1 + _e3575), _e2393));
let _e3603 = (_e600 - select(_e2406.member_2, (_e2406.member_2 + _e3576), _e2393));
let _e3608 = (((_e3601 * _e3598) + (_e3602 * _e3599)) + (_e3603 * _e3600));
let _e3613 = (((_e3601 * _e613) + (_e3602 * _e626)) + (_e3603 * _e639));
let _e3618 = (((_e3598 * _e613) + (_e3599 * _e626)) + (_e3600 * _e639));
let _e3621 = ((_e3599 * _e639) - (_e3600 * _e626));
let _e3624 = ((_e3600 * _e613) - (_e3598 * _e639));
let _e3627 = ((_e3598 * _e626) - (_e3599 * _e613));
let _e3632 = (((_e3621 * _e3621) + (_e3624 * _e3624)) + (_e3627 * _e3627));
let _e3635 = (1f / select(1e-9f, _e3632, (_e3632 > 1e-9f)));
let _e3638 = ((_e3608 - (_e3618 * _e3613)) * _e3635);
let _e3641 = (((_e3618 * _e3608) - _e3613) * _e3635);
let _e3647 = select(0f, _e3638, (((_e3641 >= 0f) && (_e3641 < _e691)) && (_e3638 > 0f)));
let _e3649 = (_e3513 << bitcast<u32>(_e3124));
if _e3361 {
phi_7968_ = (_e3140.member - 1i);
} else {
phi_7968_ = _e3360;
}
let _e3664 = phi_7968_;
if _e3516 {
phi_7979_ = (_e3140.member_1 - 1i);
} else {
phi_7979_ = _e3515;
}
let _e3667 = phi_7979_;
let _e3671 = (((f32(_e3664) + 0.5f) * _e3145) - 0.5f);
let _e3675 = (((f32(_e3667) + 0.5f) * _e3145) - 0.5f);
if _e453 {
phi_8007_ = type_23(_e3667, _e3664);
} else {
phi_8007_ = type_23(_e3664, _e3667);
}
let _e3681 = phi_8007_;
if _e3229 {
phi_8058_ = 0u;
} else {
if (_e3123 == 1u) {
phi_8057_ = 0u;
} else {
if (_e3123 == 2u) {
phi_8056_ = _e3222;
} else {
phi_8056_ = select(_e3228, _e3225, (_e3123 == 3u));
}
let _e3689 = phi_8056_;
phi_8057_ = _e3689;
}
let _e3691 = phi_8057_;
phi_8058_ = _e3691;
}
let _e3693 = phi_8058_;
local_188 = (((bitcast<i32>(_e3693) + _e3681.member_1) * _e3219) + _e3681.member);
let _e3698 = local_188;
let _e3700 = select(_e3246, _e3698, (_e3698 < _e3246));
let _e3705 = global_6.member[bitcast<u32>(select(0i, _e3700, (_e3700 > 0i)))];
let _e3710 = (((((select(_e3671, _e3675, _e453) + 0.5f) / _e2353) * 2f) - 1f) * _e2361);
let _e3715 = ((1f - (((select(_e3675, _e3671, _e453) + 0.5f) / _e2354) * 2f)) * _e2369);
let _e3722 = ((_e2372.member * _e3710) + (_e2380.member * _e3715));
let _e3723 = ((_e2372.member_1 * _e3710) + (_e2380.member_1 * _e3715));
let _e3724 = ((_e2372.member_2 * _e3710) + (_e2380.member_2 * _e3715));
let _e3728 = select((_e2395.member + _e3722), _e2395.member, _e2393);
let _e3729 = select((_e2395.member_1 + _e3723), _e2395.member_1, _e2393);
let _e3730 = select((_e2395.member_2 + _e3724), _e2395.member_2, _e2393);
let _e3741 = (((_e3728 * _e3728) + (_e3729 * _e3729)) + (_e3730 * _e3730));
let _e3745 = (1f / sqrt(select(0f, _e3741, (_e3741 > 0f))));
let _e3746 = (_e3728 * _e3745);
let _e3747 = (_e3729 * _e3745);
let _e3748 = (_e3730 * _e3745);
let _e3749 = (_e575 - select(_e2406.member, (_e2406.member + _e3722), _e2393));
let _e3750 = (_e587 - select(_e2406.member_1, (_e2406.member_1 + _e3723), _e2393));
let _e3751 = (_e600 - select(_e2406.member_2, (_e2406.member_2 + _e3724), _e2393));
let _e3756 = (((_e3749 * _e3746) + (_e3750 * _e3747)) + (_e3751 * _e3748));
let _e3761 = (((_e3749 * _e613) + (_e3750 * _e626)) + (_e3751 * _e639));
let _e3766 = (((_e3746 * _e613) + (_e3747 * _e626)) + (_e3748 * _e639));
let _e3769 = ((_e3747 * _e639) - (_e3748 * _e626));
let _e3772 = ((_e3748 * _e613) - (_e3746 * _e639));
let _e3775 = ((_e3746 * _e626) - (_e3747 * _e613));
let _e3780 = (((_e3769 * _e3769) + (_e3772 * _e3772)) + (_e3775 * _e3775));
let _e3783 = (1f / select(1e-9f, _e3780, (_e3780 > 1e-9f)));
let _e3786 = ((_e3756 - (_e3766 * _e3761)) * _e3783);
let _e3789 = (((_e3766 * _e3756) - _e3761) * _e3783);
let _e3795 = select(0f, _e3786, (((_e3789 >= 0f) && (_e3789 < _e691)) && (_e3786 > 0f)));
let _e3797 = (_e3664 << bitcast<u32>(_e3124));
let _e3809 = select(((((1f - select(0f, (_e3185 * _e3186), (((select(select(_e766, _e927, (_e3345 >= _e692)), _e847, (_e3345 < _e298)) == _e3123) && (_e3343 > 0f)) && (_e3343 < _e3253)))) - select(0f, (_e3182 * _e3186), (((select(select(_e766, _e927, (_e3497 >= _e692)), _e847, (_e3497 < _e298)) == _e3123) && (_e3495 > 0f)) && (_e3495 < _e3405)))) - select(0f, (_e3185 * _e3184), (((select(select(_e766, _e927, (_e3649 >= _e692)), _e847, (_e3649 < _e298)) == _e3123) && (_e3647 > 0f)) && (_e3647 < _e3557)))) - select(0f, (_e3182 * _e3184), (((select(select(_e766, _e927, (_e3797 >= _e692)), _e847, (_e3797 < _e298)) == _e3123) && (_e3795 > 0f)) && (_e3795 < _e3705)))), 1f, _e3229);
if _e453 {
phi_8728_ = type_23(_e2258, _e2166);
} else {
phi_8728_ = type_23(_e2166, _e2258);
}
let _e3824 = phi_8728_;
let _e3827 = (_e2259 && (((_e3121 > 0f) && (_e3121 < _e2349)) && (bitcast<f32>((bitcast<u32>(_e3809) & 2147483647u)) > 1e-6f)));
let _e3830 = global_1.member.member_18.member;
let _e3831 = (((select(_e2284, (1f - _e2284), (_e2269 >= 0f)) - select(_e2303, (1f - _e2303), (_e2288 >= 0f))) * (1f / _e2266)) * _e3830);
let _e3835 = select(0f, (((((_e652 * _e2958.member) * ((1f + (_e2998 * (1f + (_e2998 * (0.5f + (_e2998 * (0.16666667f + (_e2998 * (0.041666668f + (_e2998 * (0.008333334f + (_e2998 * (0.001388889f + (_e2998 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2993 + 127i)) << bitcast<u32>(23i))))) * _e2955) * _e3809) * _e3831), _e3827);
let _e3836 = select(0f, (((((_e665 * _e2958.member_1) * ((1f + (_e3046 * (1f + (_e3046 * (0.5f + (_e3046 * (0.16666667f + (_e3046 * (0.041666668f + (_e3046 * (0.008333334f + (_e3046 * (0.001388889f + (_e3046 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3041 + 127i)) << bitcast<u32>(23i))))) * _e2955) * _e3809) * _e3831), _e3827);
let _e3837 = select(0f, (((((_e678 * _e2958.member_2) * ((1f + (_e3094 * (1f + (_e3094 * (0.5f + (_e3094 * (0.16666667f + (_e3094 * (0.041666668f + (_e3094 * (0.008333334f + (_e3094 * (0.001388889f + (_e3094 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3089 + 127i)) << bitcast<u32>(23i))))) * _e2955) * _e3809) * _e3831), _e3827);
let _e3841 = (bitcast<f32>((bitcast<u32>(_e3835) & 2147483647u)) >= 1073741800f);
let _e3842 = (1f / 1048576f);
let _e3845 = ((_e3835 * select(1f, _e3842, _e3841)) + 0.5f);
let _e3847 = select(-1073741800f, _e3845, (_e3845 > -1073741800f));
let _e3849 = select(1073741800f, _e3847, (_e3847 < 1073741800f));
let _e3856 = select(0i, select(select(i32(_e3849), i32(-2147483648), (_e3849 < -2147483600f)), 2147483647i, (_e3849 > 2147483500f)), (_e3849 == _e3849));
let _e3860 = (_e3856 - select(0i, 1i, (_e3849 < f32(_e3856))));
let _e3861 = select(0i, 20i, _e3841);
let _e3865 = (bitcast<u32>(_e3860) << bitcast<u32>((_e3861 & 31i)));
let _e3872 = bitcast<u32>(((_e3860 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e3861) & 31i))));
let _e3876 = (bitcast<f32>((bitcast<u32>(_e3836) & 2147483647u)) >= 1073741800f);
let _e3879 = ((_e3836 * select(1f, _e3842, _e3876)) + 0.5f);
let _e3881 = select(-1073741800f, _e3879, (_e3879 > -1073741800f));
let _e3883 = select(1073741800f, _e3881, (_e3881 < 1073741800f));
let _e3890 = select(0i, select(select(i32(_e3883), i32(-2147483648), (_e3883 < -2147483600f)), 2147483647i, (_e3883 > 2147483500f)), (_e3883 == _e3883));
let _e3894 = (_e3890 - select(0i, 1i, (_e3883 < f32(_e3890))));
let _e3895 = select(0i, 20i, _e3876);
let _e3899 = (bitcast<u32>(_e3894) << bitcast<u32>((_e3895 & 31i)));
let _e3906 = bitcast<u32>(((_e3894 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e3895) & 31i))));
let _e3910 = (bitcast<f32>((bitcast<u32>(_e3837) & 2147483647u)) >= 1073741800f);
let _e3913 = ((_e3837 * select(1f, _e3842, _e3910)) + 0.5f);
let _e3915 = select(-1073741800f, _e3913, (_e3913 > -1073741800f));
let _e3917 = select(1073741800f, _e3915, (_e3915 < 1073741800f));
let _e3924 = select(0i, select(select(i32(_e3917), i32(-2147483648), (_e3917 < -2147483600f)), 2147483647i, (_e3917 > 2147483500f)), (_e3917 == _e3917));
let _e3928 = (_e3924 - select(0i, 1i, (_e3917 < f32(_e3924))));
let _e3929 = select(0i, 20i, _e3910);
let _e3933 = (bitcast<u32>(_e3928) << bitcast<u32>((_e3929 & 31i)));
let _e3940 = bitcast<u32>(((_e3928 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e3929) & 31i))));
let _e3945 = bitcast<i32>(bitcast<u32>((((_e3824.member_1 * _e935) + _e3824.member) * 6i)));
if ((_e3865 | _e3872) == 0u) {
} else {
let _e3948 = bitcast<u32>(_e3945);
if (_e3948 < _e270) {
let _e3952 = atomicAdd((&global_8.member[_e3948]), _e3865);
phi_8961_ = _e3952;
} else {
phi_8961_ = 0u;
}
let _e3954 = phi_8961_;
let _e3958 = (_e3872 + select(0u, 1u, ((_e3954 + _e3865) < _e3865)));
if (_e3958 == 0u) {
} else {
let _e3960 = (_e3948 + 1u);
if (_e3960 < _e270) {
let _e3964 = atomicAdd((&global_8.member[_e3960]), _e3958);
}
}
}
if ((_e3899 | _e3906) == 0u) {
} else {
let _e3968 = bitcast<u32>((_e3945 + 2i));
if (_e3968 < _e270) {
let _e3972 = atomicAdd((&global_8.member[_e3968]), _e3899);
phi_8991_ = _e3972;
} else {
phi_8991_ = 0u;
}
let _e3974 = phi_8991_;
let _e3978 = (_e3906 + select(0u, 1u, ((_e3974 + _e3899) < _e3899)));
if (_e3978 == 0u) {
} else {
let _e3980 = (_e3968 + 1u);
if (_e3980 < _e270) {
let _e3984 = atomicAdd((&global_8.member[_e3980]), _e3978);
}
}
}
if ((_e3933 | _e3940) == 0u) {
} else {
let _e3988 = bitcast<u32>((_e3945 + 4i));
if (_e3988 < _e270) {
let _e3992 = atomicAdd((&global_8.member[_e3988]), _e3933);
phi_9021_ = _e3992;
} else {
phi_9021_ = 0u;
}
let _e3994 = phi_9021_;
let _e3998 = (_e3940 + select(0u, 1u, ((_e3994 + _e3933) < _e3933)));
if (_e3998 == 0u) {
} else {
let _e4000 = (_e3988 + 1u);
if (_e4000 < _e270) {
let _e4004 = atomicAdd((&global_8.member[_e4000]), _e3998);
}
}
}
phi_4237_ = (_e2256 + 1i);
} else {
phi_4237_ = i32();
}
let _e4007 = phi_4237_;
continue;
continuing {
phi_4236_ = _e4007;
break if !(_e2259);
}
}
phi_4083_ = (_e2163 + 1i);
} else {
phi_4083_ = i32();
}
let _e4011 = phi_4083_;
continue;
continuing {
phi_4082_ = _e4011;
break if !(_e2164);
}
}
} else {
phi_9066_ = 0i;
loop {
let _e4014 = phi_9066_;
let _e4015 = (_e4014 < 16i);
if _e4015 {
let _e4017 = (_e980 + (_e4014 & 15i));
let _e4019 = (f32(_e4017) + 0.5f);
let _e4021 = ((_e4019 * 1f) - 0.5f);
let _e4025 = (-(((_e416 * _e4021) + _e442)) / _e429);
let _e4032 = bitcast<f32>((bitcast<u32>(((_e466 * _e4021) + ((_e479 * _e4025) + _e492))) & 2147483647u));
let _e4039 = bitcast<f32>((bitcast<u32>(((_e505 * _e4021) + ((_e518 * _e4025) + _e531))) & 2147483647u));
let _e4043 = (((0.5f * (_e4032 + _e4039)) / _e534) + _e717);
let _e4044 = (1f / 1f);
let _e4052 = ((((_e4025 + _e4043) + 0.5f) * _e4044) - 0.5f);
let _e4053 = f32(_e985);
let _e4054 = (0f - 1f);
let _e4056 = select(_e4054, _e4052, (_e4052 > _e4054));
let _e4058 = select(_e4053, _e4056, (_e4056 < _e4053));
let _e4065 = select(0i, select(select(i32(_e4058), i32(-2147483648), (_e4058 < -2147483600f)), 2147483647i, (_e4058 > 2147483500f)), (_e4058 == _e4058));
let _e4070 = (((((_e4025 - _e4043) + 0.5f) * _e4044) - 0.5f) + 1f);
let _e4071 = (_e4053 + 1f);
let _e4073 = select(0f, _e4070, (_e4070 > 0f));
let _e4075 = select(_e4071, _e4073, (_e4073 < _e4071));
let _e4082 = select(0i, select(select(i32(_e4075), i32(-2147483648), (_e4075 < -2147483600f)), 2147483647i, (_e4075 > 2147483500f)), (_e4075 == _e4075));
let _e4093 = ((1e-4f * 1f) * _e534);
let _e4095 = select(_e4039, _e4032, (_e4032 > _e4039));
let _e4097 = select(_e4093, _e4095, (_e4095 > _e4093));
let _e4099 = select(_e4039, _e4032, (_e4032 < _e4039));
let _e4101 = select(_e4093, _e4099, (_e4099 > _e4093));
let _e4103 = (0.5f * (_e4097 + _e4101));
let _e4104 = (0.5f / _e4101);
let _e4105 = (1f / _e4097);
phi_9220_ = 0i;
loop {
let _e4107 = phi_9220_;
let _e4109 = (((_e4082 - select(0i, 1i, (_e4075 < f32(_e4082)))) + (_e4014 >> bitcast<u32>(4u))) + bitcast<i32>(_e4107));
let _e4110 = (_e4109 <= select(-1i, (_e4065 - select(0i, 1i, (_e4058 < f32(_e4065)))), (_e4017 <= _e984)));
if _e4110 {
let _e4112 = (f32(_e4109) + 0.5f);
let _e4116 = ((((_e4112 * 1f) - 0.5f) - _e4025) * _e534);
let _e4117 = (_e534 * 1f);
let _e4119 = (0.5f * _e4117);
let _e4120 = (_e4116 + _e4119);
let _e4121 = -(_e4120);
let _e4124 = (_e4103 - select(_e4121, _e4120, (_e4120 > _e4121)));
let _e4126 = select(0f, _e4124, (_e4124 > 0f));
let _e4128 = select(_e4101, _e4126, (_e4126 < _e4101));
let _e4131 = (_e4124 - _e4101);
let _e4135 = (((_e4128 * (_e4128 * _e4104)) + select(0f, _e4131, (_e4131 > 0f))) * _e4105);
let _e4139 = (_e4116 - _e4119);
let _e4140 = -(_e4139);
let _e4143 = (_e4103 - select(_e4140, _e4139, (_e4139 > _e4140)));
let _e4145 = select(0f, _e4143, (_e4143 > 0f));
let _e4147 = select(_e4101, _e4145, (_e4145 < _e4101));
let _e4150 = (_e4143 - _e4101);
let _e4154 = (((_e4147 * (_e4147 * _e4104)) + select(0f, _e4150, (_e4150 > 0f))) * _e4105);
if _e453 {
phi_9325_ = type_23(_e4109, _e4017);
} else {
phi_9325_ = type_23(_e4017, _e4109);
}
let _e4163 = phi_9325_;
let _e4167 = bitcast<i32>((_e931 * _e934));
local_186 = _e4167;
local_187 = ((_e4163.member_1 * _e935) + _e4163.member);
let _e4170 = local_186;
let _e4171 = local_187;
let _e4172 = (_e4170 + _e4171);
let _e4174 = (bitcast<i32>(_e259) - 1i);
let _e4176 = select(_e4174, _e4172, (_e4172 < _e4174));
let _e4181 = global_5.member[bitcast<u32>(select(0i, _e4176, (_e4176 > 0i)))];
let _e4182 = local_186;
let _e4184 = local_187;
let _e4185 = ((2i * _e4182) + _e4184);
let _e4187 = select(_e4174, _e4185, (_e4185 < _e4174));
let _e4192 = global_5.member[bitcast<u32>(select(0i, _e4187, (_e4187 > 0i)))];
let _e4193 = local_187;
let _e4195 = select(_e4174, _e4193, (_e4193 < _e4174));
let _e4200 = global_5.member[bitcast<u32>(select(0i, _e4195, (_e4195 > 0i)))];
let _e4201 = local_187;
let _e4204 = f32(_e935);
let _e4205 = f32(_e936);
let _e4212 = global_1.member.member_2.member;
let _e4213 = (((((f32(_e4163.member) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e4220 = global_1.member.member_2.member_1;
let _e4221 = ((1f - (((f32(_e4163.member_1) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e4223 = global_1.member.member_3;
let _e4231 = global_1.member.member_4;
let _e4238 = ((_e4223.member * _e4213) + (_e4231.member * _e4221));
let _e4239 = ((_e4223.member_1 * _e4213) + (_e4231.member_1 * _e4221));
let _e4240 = ((_e4223.member_2 * _e4213) + (_e4231.member_2 * _e4221));
let _e4243 = global_1.member.member_2.member_3;
let _e4244 = (_e4243 != 0u);
let _e4246 = global_1.member.member_5;
let _e4253 = select((_e4246.member + _e4238), _e4246.member, _e4244);
let _e4254 = select((_e4246.member_1 + _e4239), _e4246.member_1, _e4244);
let _e4255 = select((_e4246.member_2 + _e4240), _e4246.member_2, _e4244);
let _e4257 = global_1.member.member_6;
let _e4264 = select(_e4257.member, (_e4257.member + _e4238), _e4244);
let _e4265 = select(_e4257.member_1, (_e4257.member_1 + _e4239), _e4244);
let _e4266 = select(_e4257.member_2, (_e4257.member_2 + _e4240), _e4244);
let _e4271 = (((_e4253 * _e4253) + (_e4254 * _e4254)) + (_e4255 * _e4255));
let _e4274 = sqrt(select(0f, _e4271, (_e4271 > 0f)));
let _e4275 = (1f / _e4274);
let _e4276 = (_e4253 * _e4275);
let _e4277 = (_e4254 * _e4275);
let _e4278 = (_e4255 * _e4275);
let _e4279 = (_e575 - _e4264);
let _e4280 = (_e587 - _e4265);
let _e4281 = (_e600 - _e4266);
let _e4286 = (((_e4279 * _e4276) + (_e4280 * _e4277)) + (_e4281 * _e4278));
let _e4291 = (((_e4279 * _e613) + (_e4280 * _e626)) + (_e4281 * _e639));
let _e4296 = (((_e4276 * _e613) + (_e4277 * _e626)) + (_e4278 * _e639));
let _e4299 = ((_e4277 * _e639) - (_e4278 * _e626));
let _e4302 = ((_e4278 * _e613) - (_e4276 * _e639));
let _e4305 = ((_e4276 * _e626) - (_e4277 * _e613));
let _e4310 = (((_e4299 * _e4299) + (_e4302 * _e4302)) + (_e4305 * _e4305));
let _e4313 = (1f / select(1e-9f, _e4310, (_e4310 > 1e-9f)));
let _e4316 = ((_e4286 - (_e4296 * _e4291)) * _e4313);
let _e4319 = (((_e4296 * _e4286) - _e4291) * _e4313);
let _e4325 = -(_e4296);
let _e4328 = global_1.member.member_13.member_2;
let _e4329 = (_e4328 * _e4328);
let _e4333 = ((1f + _e4329) - ((2f * _e4328) * _e4325));
let _e4335 = select(1e-9f, _e4333, (_e4333 > 1e-9f));
let _e4347 = global_1.member.member_13.member_3;
if (_e4347 == 2u) {
let _e4352 = (0.5f - (0.5f * _e4325));
let _e4354 = select(0f, _e4352, (_e4352 > 0f));
let _e4358 = (sqrt(select(0f, _e4354, (_e4354 > 0f))) * 255f);
let _e4359 = (255f - 1f);
let _e4361 = select(0f, _e4358, (_e4358 > 0f));
let _e4363 = select(_e4359, _e4361, (_e4361 < _e4359));
let _e4370 = select(0i, select(select(i32(_e4363), i32(-2147483648), (_e4363 < -2147483600f)), 2147483647i, (_e4363 > 2147483500f)), (_e4363 == _e4363));
let _e4374 = (_e4370 - select(0i, 1i, (_e4363 < f32(_e4370))));
let _e4377 = global_1.member.member_13.member_11;
let _e4378 = bitcast<i32>(_e4377);
let _e4379 = (_e4378 + _e4374);
let _e4381 = (bitcast<i32>(_e265) - 1i);
let _e4383 = select(_e4381, _e4379, (_e4379 < _e4381));
let _e4388 = global_2.member[bitcast<u32>(select(0i, _e4383, (_e4383 > 0i)))];
let _e4390 = (_e4378 + (_e4374 + 1i));
let _e4392 = select(_e4381, _e4390, (_e4390 < _e4381));
let _e4397 = global_2.member[bitcast<u32>(select(0i, _e4392, (_e4392 > 0i)))];
phi_9752_ = (_e4388 + ((_e4397 - _e4388) * (_e4358 - f32(_e4374))));
} else {
phi_9752_ = select(((1f - _e4329) / (_e4335 * sqrt(select(0f, _e4335, (_e4335 > 0f))))), (0.75f * (1f + (_e4325 * _e4325))), (_e4347 == 1u));
}
let _e4404 = phi_9752_;
let _e4410 = global_1.member.member_12.member_11;
let _e4413 = global_1.member.member_12.member_4;
let _e4416 = global_1.member.member_12.member_12;
let _e4422 = global_1.member.member.member;
let _e4424 = (_e4319 / _e691);
local_183 = bitcast<i32>((_e4410 + (_e4413 * _e4416)));
local_184 = _e281;
local_185 = bitcast<i32>(_e4422);
let _e4427 = global_1.member.member_13.member_6;
let _e4428 = f32(_e4427);
let _e4430 = select(0f, _e4424, (_e4424 > 0f));
let _e4433 = (select(1f, _e4430, (_e4430 < 1f)) * _e4428);
let _e4434 = (_e4428 - 1f);
let _e4436 = select(0f, _e4434, (_e4434 > 0f));
let _e4438 = select(0f, _e4433, (_e4433 > 0f));
let _e4440 = select(_e4436, _e4438, (_e4438 < _e4436));
let _e4447 = select(0i, select(select(i32(_e4440), i32(-2147483648), (_e4440 < -2147483600f)), 2147483647i, (_e4440 > 2147483500f)), (_e4440 == _e4440));
let _e4451 = (_e4447 - select(0i, 1i, (_e4440 < f32(_e4447))));
if (_e4451 > 0i) {
let _e4454 = local_183;
let _e4455 = local_185;
let _e4458 = local_184;
let _e4459 = ((_e4454 + ((_e4451 - 1i) * _e4455)) + _e4458);
let _e4461 = (bitcast<i32>(_e268) - 1i);
let _e4463 = select(_e4461, _e4459, (_e4459 < _e4461));
let _e4468 = global_7.member[bitcast<u32>(select(0i, _e4463, (_e4463 > 0i)))];
phi_9858_ = _e4468;
} else {
phi_9858_ = 0f;
}
let _e4470 = phi_9858_;
let _e4471 = local_183;
let _e4472 = local_185;
let _e4475 = local_184;
let _e4476 = ((_e4471 + (_e4451 * _e4472)) + _e4475);
let _e4478 = (bitcast<i32>(_e268) - 1i);
let _e4480 = select(_e4478, _e4476, (_e4476 < _e4478));
let _e4485 = global_7.member[bitcast<u32>(select(0i, _e4480, (_e4480 > 0i)))];
let _e4492 = (_e4192 - _e4181);
let _e4495 = ((_e4316 - _e4181) / select(1e-9f, _e4492, (_e4492 > 1e-9f)));
local_180 = 0i;
local_181 = _e4201;
local_182 = _e4167;
let _e4497 = select(0f, _e4495, (_e4495 > 0f));
let _e4500 = (select(1f, _e4497, (_e4497 < 1f)) * _e4428);
let _e4502 = select(0f, _e4500, (_e4500 > 0f));
let _e4504 = select(_e4436, _e4502, (_e4502 < _e4436));
let _e4511 = select(0i, select(select(i32(_e4504), i32(-2147483648), (_e4504 < -2147483600f)), 2147483647i, (_e4504 > 2147483500f)), (_e4504 == _e4504));
let _e4515 = (_e4511 - select(0i, 1i, (_e4504 < f32(_e4511))));
if (_e4515 > 0i) {
let _e4518 = local_180;
let _e4519 = local_182;
let _e4522 = local_181;
let _e4523 = ((_e4518 + ((_e4515 - 1i) * _e4519)) + _e4522);
let _e4525 = select(_e4478, _e4523, (_e4523 < _e4478));
let _e4530 = global_7.member[bitcast<u32>(select(0i, _e4525, (_e4525 > 0i)))];
phi_9985_ = _e4530;
} else {
phi_9985_ = 0f;
}
let _e4532 = phi_9985_;
let _e4533 = local_180;
let _e4534 = local_182;
let _e4537 = local_181;
let _e4538 = ((_e4533 + (_e4515 * _e4534)) + _e4537);
let _e4540 = select(_e4478, _e4538, (_e4538 < _e4478));
let _e4545 = global_7.member[bitcast<u32>(select(0i, _e4540, (_e4540 > 0i)))];
let _e4551 = ((_e4470 + ((_e4485 - _e4470) * (_e4433 - f32(_e4451)))) + (_e4532 + ((_e4545 - _e4532) * (_e4500 - f32(_e4515)))));
let _e4560 = global_1.member.member_13.member_7;
let _e4561 = bitcast<i32>(_e4560);
let _e4564 = global_1.member.member_13.member_8;
let _e4565 = bitcast<i32>(_e4564);
let _e4568 = global_1.member.member_13.member_9;
let _e4569 = bitcast<i32>(_e4568);
let _e4572 = global_1.member.member_13.member_4;
let _e4578 = global_1.member.member_13.member_5;
let _e4582 = f32(_e4561);
let _e4587 = (((((_e4264 + (_e4276 * _e4316)) - _e4572.member) / (_e4578.member - _e4572.member)) * _e4582) - 0.5f);
let _e4588 = (_e4582 - 1f);
let _e4590 = select(0f, _e4587, (_e4587 > 0f));
let _e4592 = select(_e4588, _e4590, (_e4590 < _e4588));
let _e4593 = f32(_e4565);
let _e4598 = (((((_e4265 + (_e4277 * _e4316)) - _e4572.member_1) / (_e4578.member_1 - _e4572.member_1)) * _e4593) - 0.5f);
let _e4599 = (_e4593 - 1f);
let _e4601 = select(0f, _e4598, (_e4598 > 0f));
let _e4603 = select(_e4599, _e4601, (_e4601 < _e4599));
let _e4604 = f32(_e4569);
let _e4609 = (((((_e4266 + (_e4278 * _e4316)) - _e4572.member_2) / (_e4578.member_2 - _e4572.member_2)) * _e4604) - 0.5f);
let _e4610 = (_e4604 - 1f);
let _e4612 = select(0f, _e4609, (_e4609 > 0f));
let _e4614 = select(_e4610, _e4612, (_e4612 < _e4610));
let _e4616 = select(0f, _e4592, (_e4592 > 0f));
let _e4618 = select(1e6f, _e4616, (_e4616 < 1e6f));
let _e4625 = select(0i, select(select(i32(_e4618), i32(-2147483648), (_e4618 < -2147483600f)), 2147483647i, (_e4618 > 2147483500f)), (_e4618 == _e4618));
let _e4629 = (_e4625 - select(0i, 1i, (_e4618 < f32(_e4625))));
let _e4631 = select(0f, _e4603, (_e4603 > 0f));
let _e4633 = select(1e6f, _e4631, (_e4631 < 1e6f));
let _e4640 = select(0i, select(select(i32(_e4633), i32(-2147483648), (_e4633 < -2147483600f)), 2147483647i, (_e4633 > 2147483500f)), (_e4633 == _e4633));
let _e4644 = (_e4640 - select(0i, 1i, (_e4633 < f32(_e4640))));
let _e4646 = select(0f, _e4614, (_e4614 > 0f));
let _e4648 = select(1e6f, _e4646, (_e4646 < 1e6f));
let _e4655 = select(0i, select(select(i32(_e4648), i32(-2147483648), (_e4648 < -2147483600f)), 2147483647i, (_e4648 > 2147483500f)), (_e4648 == _e4648));
let _e4659 = (_e4655 - select(0i, 1i, (_e4648 < f32(_e4655))));
let _e4663 = (_e4603 - f32(_e4644));
let _e4665 = (_e4614 - f32(_e4659));
local_178 = (_e4592 - f32(_e4629));
let _e4666 = (_e4629 + 1i);
let _e4668 = select(_e4666, 0i, (_e4666 < 0i));
if (_e4668 >= _e4561) {
phi_10133_ = (_e4561 - 1i);
} else {
phi_10133_ = _e4668;
}
let _e4672 = phi_10133_;
local_179 = (_e4672 - _e4629);
let _e4674 = (_e4644 + 1i);
let _e4676 = select(_e4674, 0i, (_e4674 < 0i));
if (_e4676 >= _e4565) {
phi_10146_ = (_e4565 - 1i);
} else {
phi_10146_ = _e4676;
}
let _e4680 = phi_10146_;
let _e4682 = ((_e4680 - _e4644) * _e4561);
let _e4683 = (_e4659 + 1i);
let _e4685 = select(_e4683, 0i, (_e4683 < 0i));
if (_e4685 >= _e4569) {
phi_10160_ = (_e4569 - 1i);
} else {
phi_10160_ = _e4685;
}
let _e4689 = phi_10160_;
let _e4695 = global_1.member.member_13.member_10;
let _e4701 = ((bitcast<i32>(_e4695) + (((_e4659 * _e4565) + _e4644) * _e4561)) + _e4629);
let _e4703 = (bitcast<i32>(_e265) - 1i);
let _e4705 = select(_e4703, _e4701, (_e4701 < _e4703));
let _e4710 = global_2.member[bitcast<u32>(select(0i, _e4705, (_e4705 > 0i)))];
let _e4711 = local_178;
let _e4714 = local_179;
let _e4715 = (_e4701 + _e4714);
let _e4717 = select(_e4703, _e4715, (_e4715 < _e4703));
let _e4722 = global_2.member[bitcast<u32>(select(0i, _e4717, (_e4717 > 0i)))];
let _e4723 = local_178;
let _e4726 = (1f - _e4663);
let _e4728 = (_e4701 + _e4682);
let _e4730 = select(_e4703, _e4728, (_e4728 < _e4703));
let _e4735 = global_2.member[bitcast<u32>(select(0i, _e4730, (_e4730 > 0i)))];
let _e4736 = local_178;
let _e4739 = local_179;
let _e4740 = (_e4728 + _e4739);
let _e4742 = select(_e4703, _e4740, (_e4740 < _e4703));
let _e4747 = global_2.member[bitcast<u32>(select(0i, _e4742, (_e4742 > 0i)))];
let _e4748 = local_178;
let _e4753 = (_e4701 + (((_e4689 - _e4659) * _e4561) * _e4565));
let _e4755 = select(_e4703, _e4753, (_e4753 < _e4703));
let _e4760 = global_2.member[bitcast<u32>(select(0i, _e4755, (_e4755 > 0i)))];
let _e4761 = local_178;
let _e4764 = local_179;
let _e4765 = (_e4753 + _e4764);
let _e4767 = select(_e4703, _e4765, (_e4765 < _e4703));
let _e4772 = global_2.member[bitcast<u32>(select(0i, _e4767, (_e4767 > 0i)))];
let _e4773 = local_178;
let _e4777 = (_e4753 + _e4682);
let _e4779 = select(_e4703, _e4777, (_e4777 < _e4703));
let _e4784 = global_2.member[bitcast<u32>(select(0i, _e4779, (_e4779 > 0i)))];
let _e4785 = local_178;
let _e4788 = local_179;
let _e4789 = (_e4777 + _e4788);
let _e4791 = select(_e4703, _e4789, (_e4789 < _e4703));
let _e4796 = global_2.member[bitcast<u32>(select(0i, _e4791, (_e4791 > 0i)))];
let _e4797 = local_178;
let _e4806 = ((_e4274 * (_e4404 * (0.25f / 3.1415927f))) * ((((((_e4710 * (1f - _e4711)) + (_e4722 * _e4723)) * _e4726) + (((_e4735 * (1f - _e4736)) + (_e4747 * _e4748)) * _e4663)) * (1f - _e4665)) + (((((_e4760 * (1f - _e4761)) + (_e4772 * _e4773)) * _e4726) + (((_e4784 * (1f - _e4785)) + (_e4796 * _e4797)) * _e4663)) * _e4665)));
let _e4809 = global_1.member.member_13.member_1;
let _e4818 = global_1.member.member_13.member;
let _e4823 = -((_e4818.member * _e4551));
let _e4825 = select(-87f, _e4823, (_e4823 > -87f));
let _e4827 = select(88f, _e4825, (_e4825 < 88f));
let _e4829 = ((_e4827 * 1.442695f) + 0.5f);
let _e4831 = select(-127f, _e4829, (_e4829 > -127f));
let _e4833 = select(128f, _e4831, (_e4831 < 128f));
let _e4840 = select(0i, select(select(i32(_e4833), i32(-2147483648), (_e4833 < -2147483600f)), 2147483647i, (_e4833 > 2147483500f)), (_e4833 == _e4833));
let _e4844 = (_e4840 - select(0i, 1i, (_e4833 < f32(_e4840))));
let _e4845 = f32(_e4844);
let _e4849 = ((_e4827 - (_e4845 * 0.6933594f)) - (_e4845 * -2.1219444e-4f));
let _e4871 = -((_e4818.member_1 * _e4551));
let _e4873 = select(-87f, _e4871, (_e4871 > -87f));
let _e4875 = select(88f, _e4873, (_e4873 < 88f));
let _e4877 = ((_e4875 * 1.442695f) + 0.5f);
let _e4879 = select(-127f, _e4877, (_e4877 > -127f));
let _e4881 = select(128f, _e4879, (_e4879 < 128f));
let _e4888 = select(0i, select(select(i32(_e4881), i32(-2147483648), (_e4881 < -2147483600f)), 2147483647i, (_e4881 > 2147483500f)), (_e4881 == _e4881));
let _e4892 = (_e4888 - select(0i, 1i, (_e4881 < f32(_e4888))));
let _e4893 = f32(_e4892);
let _e4897 = ((_e4875 - (_e4893 * 0.6933594f)) - (_e4893 * -2.1219444e-4f));
let _e4919 = -((_e4818.member_2 * _e4551));
let _e4921 = select(-87f, _e4919, (_e4919 > -87f));
let _e4923 = select(88f, _e4921, (_e4921 < 88f));
let _e4925 = ((_e4923 * 1.442695f) + 0.5f);
let _e4927 = select(-127f, _e4925, (_e4925 > -127f));
let _e4929 = select(128f, _e4927, (_e4927 < 128f));
let _e4936 = select(0i, select(select(i32(_e4929), i32(-2147483648), (_e4929 < -2147483600f)), 2147483647i, (_e4929 > 2147483500f)), (_e4929 == _e4929));
let _e4940 = (_e4936 - select(0i, 1i, (_e4929 < f32(_e4936))));
let _e4941 = f32(_e4940);
let _e4945 = ((_e4923 - (_e4941 * 0.6933594f)) - (_e4941 * -2.1219444e-4f));
let _e4972 = select(0f, _e4316, (((_e4319 >= 0f) && (_e4319 < _e691)) && (_e4316 > 0f)));
let _e4973 = (_e766 & 31u);
let _e4975 = (1u << bitcast<u32>(_e4973));
let _e4984 = bitcast<i32>((((_e931 + _e4975) - 1u) >> bitcast<u32>(_e4973)));
let _e4985 = bitcast<i32>((((_e934 + _e4975) - 1u) >> bitcast<u32>(_e4973)));
if _e453 {
phi_10619_ = type_23(_e4985, _e4984);
} else {
phi_10619_ = type_23(_e4984, _e4985);
}
let _e4989 = phi_10619_;
let _e4994 = f32((1i << bitcast<u32>(_e4973)));
let _e4995 = (1f / _e4994);
let _e4997 = ((_e4019 * _e4995) - 0.5f);
let _e4999 = ((_e4112 * _e4995) - 0.5f);
let _e5001 = select(-1f, _e4997, (_e4997 > -1f));
let _e5003 = select(1e6f, _e5001, (_e5001 < 1e6f));
let _e5010 = select(0i, select(select(i32(_e5003), i32(-2147483648), (_e5003 < -2147483600f)), 2147483647i, (_e5003 > 2147483500f)), (_e5003 == _e5003));
let _e5014 = (_e5010 - select(0i, 1i, (_e5003 < f32(_e5010))));
let _e5016 = select(-1f, _e4999, (_e4999 > -1f));
let _e5018 = select(1e6f, _e5016, (_e5016 < 1e6f));
let _e5025 = select(0i, select(select(i32(_e5018), i32(-2147483648), (_e5018 < -2147483600f)), 2147483647i, (_e5018 > 2147483500f)), (_e5018 == _e5018));
let _e5029 = (_e5025 - select(0i, 1i, (_e5018 < f32(_e5025))));
let _e5031 = (_e4997 - f32(_e5014));
let _e5033 = (_e4999 - f32(_e5029));
let _e5034 = (1f - _e5031);
let _e5035 = (1f - _e5033);
let _e5038 = select(_e5014, 0i, (_e5014 < 0i));
let _e5039 = (_e5038 >= _e4989.member);
if _e5039 {
phi_10697_ = (_e4989.member - 1i);
} else {
phi_10697_ = _e5038;
}
let _e5042 = phi_10697_;
let _e5044 = select(_e5029, 0i, (_e5029 < 0i));
let _e5045 = (_e5044 >= _e4989.member_1);
if _e5045 {
phi_10708_ = (_e4989.member_1 - 1i);
} else {
phi_10708_ = _e5044;
}
let _e5048 = phi_10708_;
let _e5052 = (((f32(_e5042) + 0.5f) * _e4994) - 0.5f);
let _e5056 = (((f32(_e5048) + 0.5f) * _e4994) - 0.5f);
if _e453 {
phi_10736_ = type_23(_e5048, _e5042);
} else {
phi_10736_ = type_23(_e5042, _e5048);
}
let _e5062 = phi_10736_;
let _e5068 = bitcast<i32>(((_e931 + 1u) >> bitcast<u32>(1u)));
let _e5071 = global_1.member.member_18.member_6;
let _e5074 = global_1.member.member_18.member_7;
let _e5077 = global_1.member.member_18.member_8;
if _e986 {
phi_10787_ = 0u;
} else {
if (_e766 == 1u) {
phi_10786_ = 0u;
} else {
if (_e766 == 2u) {
phi_10785_ = _e5071;
} else {
phi_10785_ = select(_e5077, _e5074, (_e766 == 3u));
}
let _e5083 = phi_10785_;
phi_10786_ = _e5083;
}
let _e5085 = phi_10786_;
phi_10787_ = _e5085;
}
let _e5087 = phi_10787_;
local_176 = (((bitcast<i32>(_e5087) + _e5062.member_1) * _e5068) + _e5062.member);
let _e5092 = local_176;
let _e5094 = (bitcast<i32>(_e262) - 1i);
let _e5096 = select(_e5094, _e5092, (_e5092 < _e5094));
let _e5101 = global_6.member[bitcast<u32>(select(0i, _e5096, (_e5096 > 0i)))];
let _e5106 = (((((select(_e5052, _e5056, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e5111 = ((1f - (((select(_e5056, _e5052, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e5118 = ((_e4223.member * _e5106) + (_e4231.member * _e5111));
let _e5119 = ((_e4223.member_1 * _e5106) + (_e4231.member_1 * _e5111));
let _e5120 = ((_e4223.member_2 * _e5106) + (_e4231.member_2 * _e5111));
let _e5124 = select((_e4246.member + _e5118), _e4246.member, _e4244);
let _e5125 = select((_e4246.member_1 + _e5119), _e4246.member_1, _e4244);
let _e5126 = select((_e4246.member_2 + _e5120), _e4246.member_2, _e4244);
let _e5137 = (((_e5124 * _e5124) + (_e5125 * _e5125)) + (_e5126 * _e5126));
let _e5141 = (1f / sqrt(select(0f, _e5137, (_e5137 > 0f))));
let _e5142 = (_e5124 * _e5141);
let _e5143 = (_e5125 * _e5141);
let _e5144 = (_e5126 * _e5141);
let _e5145 = (_e575 - select(_e4257.member, (_e4257.member + _e5118), _e4244));
let _e5146 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e5119), _e4244));
let _e5147 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e5120), _e4244));
let _e5152 = (((_e5145 * _e5142) + (_e5146 * _e5143)) + (_e5147 * _e5144));
let _e5157 = (((_e5145 * _e613) + (_e5146 * _e626)) + (_e5147 * _e639));
let _e5162 = (((_e5142 * _e613) + (_e5143 * _e626)) + (_e5144 * _e639));
let _e5165 = ((_e5143 * _e639) - (_e5144 * _e626));
let _e5168 = ((_e5144 * _e613) - (_e5142 * _e639));
let _e5171 = ((_e5142 * _e626) - (_e5143 * _e613));
let _e5176 = (((_e5165 * _e5165) + (_e5168 * _e5168)) + (_e5171 * _e5171));
let _e5179 = (1f / select(1e-9f, _e5176, (_e5176 > 1e-9f)));
let _e5182 = ((_e5152 - (_e5162 * _e5157)) * _e5179);
let _e5185 = (((_e5162 * _e5152) - _e5157) * _e5179);
let _e5191 = select(0f, _e5182, (((_e5185 >= 0f) && (_e5185 < _e691)) && (_e5182 > 0f)));
let _e5193 = (_e5042 << bitcast<u32>(_e4973));
let _e5205 = (_e5014 + 1i);
let _e5208 = select(_e5205, 0i, (_e5205 < 0i));
let _e5209 = (_e5208 >= _e4989.member);
if _e5209 {
phi_11448_ = (_e4989.member - 1i);
} else {
phi_11448_ = _e5208;
}
let _e5212 = phi_11448_;
if _e5045 {
phi_11459_ = (_e4989.member_1 - 1i);
} else {
phi_11459_ = _e5044;
}
let _e5215 = phi_11459_;
let _e5219 = (((f32(_e5212) + 0.5f) * _e4994) - 0.5f);
let _e5223 = (((f32(_e5215) + 0.5f) * _e4994) - 0.5f);
if _e453 {
phi_11487_ = type_23(_e5215, _e5212);
} else {
phi_11487_ = type_23(_e5212, _e5215);
}
let _e5229 = phi_11487_;
if _e986 {
phi_11538_ = 0u;
} else {
if (_e766 == 1u) {
phi_11537_ = 0u;
} else {
if (_e766 == 2u) {
phi_11536_ = _e5071;
} else {
phi_11536_ = select(_e5077, _e5074, (_e766 == 3u));
}
let _e5237 = phi_11536_;
phi_11537_ = _e5237;
}
let _e5239 = phi_11537_;
phi_11538_ = _e5239;
}
let _e5241 = phi_11538_;
local_174 = (((bitcast<i32>(_e5241) + _e5229.member_1) * _e5068) + _e5229.member);
let _e5246 = local_174;
let _e5248 = select(_e5094, _e5246, (_e5246 < _e5094));
let _e5253 = global_6.member[bitcast<u32>(select(0i, _e5248, (_e5248 > 0i)))];
let _e5258 = (((((select(_e5219, _e5223, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e5263 = ((1f - (((select(_e5223, _e5219, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e5270 = ((_e4223.member * _e5258) + (_e4231.member * _e5263));
let _e5271 = ((_e4223.member_1 * _e5258) + (_e4231.member_1 * _e5263));
let _e5272 = ((_e4223.member_2 * _e5258) + (_e4231.member_2 * _e5263));
let _e5276 = select((_e4246.member + _e5270), _e4246.member, _e4244);
let _e5277 = select((_e4246.member_1 + _e5271), _e4246.member_1, _e4244);
let _e5278 = select((_e4246.member_2 + _e5272), _e4246.member_2, _e4244);
let _e5289 = (((_e5276 * _e5276) + (_e5277 * _e5277)) + (_e5278 * _e5278));
let _e5293 = (1f / sqrt(select(0f, _e5289, (_e5289 > 0f))));
let _e5294 = (_e5276 * _e5293);
let _e5295 = (_e5277 * _e5293);
let _e5296 = (_e5278 * _e5293);
let _e5297 = (_e575 - select(_e4257.member, (_e4257.member + _e5270), _e4244));
let _e5298 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e5271), _e4244));
let _e5299 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e5272), _e4244));
let _e5304 = (((_e5297 * _e5294) + (_e5298 * _e5295)) + (_e5299 * _e5296));
let _e5309 = (((_e5297 * _e613) + (_e5298 * _e626)) + (_e5299 * _e639));
let _e5314 = (((_e5294 * _e613) + (_e5295 * _e626)) + (_e5296 * _e639));
let _e5317 = ((_e5295 * _e639) - (_e5296 * _e626));
let _e5320 = ((_e5296 * _e613) - (_e5294 * _e639));
let _e5323 = ((_e5294 * _e626) - (_e5295 * _e613));
let _e5328 = (((_e5317 * _e5317) + (_e5320 * _e5320)) + (_e5323 * _e5323));
let _e5331 = (1f / select(1e-9f, _e5328, (_e5328 > 1e-9f)));
let _e5334 = ((_e5304 - (_e5314 * _e5309)) * _e5331);
let _e5337 = (((_e5314 * _e5304) - _e5309) * _e5331);
let _e5343 = select(0f, _e5334, (((_e5337 >= 0f) && (_e5337 < _e691)) && (_e5334 > 0f)));
let _e5345 = (_e5212 << bitcast<u32>(_e4973));
let _e5357 = (_e5029 + 1i);
if _e5039 {
phi_12199_ = (_e4989.member - 1i);
} else {
phi_12199_ = _e5038;
}
let _e5361 = phi_12199_;
let _e5363 = select(_e5357, 0i, (_e5357 < 0i));
let _e5364 = (_e5363 >= _e4989.member_1);
if _e5364 {
phi_12210_ = (_e4989.member_1 - 1i);
} else {
phi_12210_ = _e5363;
}
let _e5367 = phi_12210_;
let _e5371 = (((f32(_e5361) + 0.5f) * _e4994) - 0.5f);
let _e5375 = (((f32(_e5367) + 0.5f) * _e4994) - 0.5f);
if _e453 {
phi_12238_ = type_23(_e5367, _e5361);
} else {
phi_12238_ = type_23(_e5361, _e5367);
}
let _e5381 = phi_12238_;
if _e986 {
phi_12289_ = 0u;
} else {
if (_e766 == 1u) {
phi_12288_ = 0u;
} else {
if (_e766 == 2u) {
phi_12287_ = _e5071;
} else {
phi_12287_ = select(_e5077, _e5074, (_e766 == 3u));
}
let _e5389 = phi_12287_;
phi_12288_ = _e5389;
}
let _e5391 = phi_12288_;
phi_12289_ = _e5391;
}
let _e5393 = phi_12289_;
local_172 = (((bitcast<i32>(_e5393) + _e5381.member_1) * _e5068) + _e5381.member);
let _e5398 = local_172;
let _e5400 = select(_e5094, _e5398, (_e5398 < _e5094));
let _e5405 = global_6.member[bitcast<u32>(select(0i, _e5400, (_e5400 > 0i)))];
let _e5410 = (((((select(_e5371, _e5375, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e5415 = ((1f - (((select(_e5375, _e5371, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e5422 = ((_e4223.member * _e5410) + (_e4231.member * _e5415));
let _e5423 = ((_e4223.member_1 * _e5410) + (_e4231.member_1 * _e5415));
let _e5424 = ((_e4223.member_2 * _e5410) + (_e4231.member_2 * _e5415));
let _e5428 = select((_e4246.member + _e5422), _e4246.member, _e4244);
let _e5429 = select((_e4246.member_1 + _e5423), _e4246.member_1, _e4244);
let _e5430 = select((_e4246.member_2 + _e5424), _e4246.member_2, _e4244);
let _e5441 = (((_e5428 * _e5428) + (_e5429 * _e5429)) + (_e5430 * _e5430));
let _e5445 = (1f / sqrt(select(0f, _e5441, (_e5441 > 0f))));
let _e5446 = (_e5428 * _e5445);
let _e5447 = (_e5429 * _e5445);
let _e5448 = (_e5430 * _e5445);
let _e5449 = (_e575 - select(_e4257.member, (_e4257.member + _e5422), _e4244));
let _e5450 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e5423), _e4244));
let _e5451 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e5424), _e4244));
let _e5456 = (((_e5449 * _e5446) + (_e5450 * _e5447)) + (_e5451 * _e5448));
let _e5461 = (((_e5449 * _e613) + (_e5450 * _e626)) + (_e5451 * _e639));
let _e5466 = (((_e5446 * _e613) + (_e5447 * _e626)) + (_e5448 * _e639));
let _e5469 = ((_e5447 * _e639) - (_e5448 * _e626));
let _e5472 = ((_e5448 * _e613) - (_e5446 * _e639));
let _e5475 = ((_e5446 * _e626) - (_e5447 * _e613));
let _e5480 = (((_e5469 * _e5469) + (_e5472 * _e5472)) + (_e5475 * _e5475));
let _e5483 = (1f / select(1e-9f, _e5480, (_e5480 > 1e-9f)));
let _e5486 = ((_e5456 - (_e5466 * _e5461)) * _e5483);
let _e5489 = (((_e5466 * _e5456) - _e5461) * _e5483);
let _e5495 = select(0f, _e5486, (((_e5489 >= 0f) && (_e5489 < _e691)) && (_e5486 > 0f)));
let _e5497 = (_e5361 << bitcast<u32>(_e4973));
if _e5209 {
phi_12950_ = (_e4989.member - 1i);
} else {
phi_12950_ = _e5208;
}
let _e5512 = phi_12950_;
if _e5364 {
phi_12961_ = (_e4989.member_1 - 1i);
} else {
phi_12961_ = _e5363;
}
let _e5515 = phi_12961_;
let _e5519 = (((f32(_e5512) + 0.5f) * _e4994) - 0.5f);
let _e5523 = (((f32(_e5515) + 0.5f) * _e4994) - 0.5f);
if _e453 {
phi_12989_ = type_23(_e5515, _e5512);
} else {
phi_12989_ = type_23(_e5512, _e5515);
}
let _e5529 = phi_12989_;
if _e986 {
phi_13040_ = 0u;
} else {
if (_e766 == 1u) {
phi_13039_ = 0u;
} else {
if (_e766 == 2u) {
phi_13038_ = _e5071;
} else {
phi_13038_ = select(_e5077, _e5074, (_e766 == 3u));
}
let _e5537 = phi_13038_;
phi_13039_ = _e5537;
}
let _e5539 = phi_13039_;
phi_13040_ = _e5539;
}
let _e5541 = phi_13040_;
local_170 = (((bitcast<i32>(_e5541) + _e5529.member_1) * _e5068) + _e5529.member);
let _e5546 = local_170;
let _e5548 = select(_e5094, _e5546, (_e5546 < _e5094));
let _e5553 = global_6.member[bitcast<u32>(select(0i, _e5548, (_e5548 > 0i)))];
let _e5558 = (((((select(_e5519, _e5523, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e5563 = ((1f - (((select(_e5523, _e5519, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e5570 = ((_e4223.member * _e5558) + (_e4231.member * _e5563));
let _e5571 = ((_e4223.member_1 * _e5558) + (_e4231.member_1 * _e5563));
let _e5572 = ((_e4223.member_2 * _e5558) + (_e4231.member_2 * _e5563));
let _e5576 = select((_e4246.member + _e5570), _e4246.member, _e4244);
let _e5577 = select((_e4246.member_1 + _e5571), _e4246.member_1, _e4244);
let _e5578 = select((_e4246.member_2 + _e5572), _e4246.member_2, _e4244);
let _e5589 = (((_e5576 * _e5576) + (_e5577 * _e5577)) + (_e5578 * _e5578));
let _e5593 = (1f / sqrt(select(0f, _e5589, (_e5589 > 0f))));
let _e5594 = (_e5576 * _e5593);
let _e5595 = (_e5577 * _e5593);
let _e5596 = (_e5578 * _e5593);
let _e5597 = (_e575 - select(_e4257.member, (_e4257.member + _e5570), _e4244));
let _e5598 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e5571), _e4244));
let _e5599 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e5572), _e4244));
let _e5604 = (((_e5597 * _e5594) + (_e5598 * _e5595)) + (_e5599 * _e5596));
let _e5609 = (((_e5597 * _e613) + (_e5598 * _e626)) + (_e5599 * _e639));
let _e5614 = (((_e5594 * _e613) + (_e5595 * _e626)) + (_e5596 * _e639));
let _e5617 = ((_e5595 * _e639) - (_e5596 * _e626));
let _e5620 = ((_e5596 * _e613) - (_e5594 * _e639));
let _e5623 = ((_e5594 * _e626) - (_e5595 * _e613));
let _e5628 = (((_e5617 * _e5617) + (_e5620 * _e5620)) + (_e5623 * _e5623));
let _e5631 = (1f / select(1e-9f, _e5628, (_e5628 > 1e-9f)));
let _e5634 = ((_e5604 - (_e5614 * _e5609)) * _e5631);
let _e5637 = (((_e5614 * _e5604) - _e5609) * _e5631);
let _e5643 = select(0f, _e5634, (((_e5637 >= 0f) && (_e5637 < _e691)) && (_e5634 > 0f)));
let _e5645 = (_e5512 << bitcast<u32>(_e4973));
let _e5657 = select(((((1f - select(0f, (_e5034 * _e5035), (((select(select(_e766, _e927, (_e5193 >= _e692)), _e847, (_e5193 < _e298)) == _e766) && (_e5191 > 0f)) && (_e5191 < _e5101)))) - select(0f, (_e5031 * _e5035), (((select(select(_e766, _e927, (_e5345 >= _e692)), _e847, (_e5345 < _e298)) == _e766) && (_e5343 > 0f)) && (_e5343 < _e5253)))) - select(0f, (_e5034 * _e5033), (((select(select(_e766, _e927, (_e5497 >= _e692)), _e847, (_e5497 < _e298)) == _e766) && (_e5495 > 0f)) && (_e5495 < _e5405)))) - select(0f, (_e5031 * _e5033), (((select(select(_e766, _e927, (_e5645 >= _e692)), _e847, (_e5645 < _e298)) == _e766) && (_e5643 > 0f)) && (_e5643 < _e5553)))), 1f, _e986);
let _e5658 = (_e988 & 31u);
let _e5660 = (1u << bitcast<u32>(_e5658));
let _e5669 = bitcast<i32>((((_e931 + _e5660) - 1u) >> bitcast<u32>(_e5658)));
let _e5670 = bitcast<i32>((((_e934 + _e5660) - 1u) >> bitcast<u32>(_e5658)));
if _e453 {
phi_13719_ = type_23(_e5670, _e5669);
} else {
phi_13719_ = type_23(_e5669, _e5670);
}
let _e5674 = phi_13719_;
let _e5679 = f32((1i << bitcast<u32>(_e5658)));
let _e5680 = (1f / _e5679);
let _e5682 = ((_e4019 * _e5680) - 0.5f);
let _e5684 = ((_e4112 * _e5680) - 0.5f);
let _e5686 = select(-1f, _e5682, (_e5682 > -1f));
let _e5688 = select(1e6f, _e5686, (_e5686 < 1e6f));
let _e5695 = select(0i, select(select(i32(_e5688), i32(-2147483648), (_e5688 < -2147483600f)), 2147483647i, (_e5688 > 2147483500f)), (_e5688 == _e5688));
let _e5699 = (_e5695 - select(0i, 1i, (_e5688 < f32(_e5695))));
let _e5701 = select(-1f, _e5684, (_e5684 > -1f));
let _e5703 = select(1e6f, _e5701, (_e5701 < 1e6f));
let _e5710 = select(0i, select(select(i32(_e5703), i32(-2147483648), (_e5703 < -2147483600f)), 2147483647i, (_e5703 > 2147483500f)), (_e5703 == _e5703));
let _e5714 = (_e5710 - select(0i, 1i, (_e5703 < f32(_e5710))));
let _e5716 = (_e5682 - f32(_e5699));
let _e5718 = (_e5684 - f32(_e5714));
let _e5719 = (1f - _e5716);
let _e5720 = (1f - _e5718);
let _e5723 = select(_e5699, 0i, (_e5699 < 0i));
let _e5724 = (_e5723 >= _e5674.member);
if _e5724 {
phi_13797_ = (_e5674.member - 1i);
} else {
phi_13797_ = _e5723;
}
let _e5727 = phi_13797_;
let _e5729 = select(_e5714, 0i, (_e5714 < 0i));
let _e5730 = (_e5729 >= _e5674.member_1);
if _e5730 {
phi_13808_ = (_e5674.member_1 - 1i);
} else {
phi_13808_ = _e5729;
}
let _e5733 = phi_13808_;
let _e5737 = (((f32(_e5727) + 0.5f) * _e5679) - 0.5f);
let _e5741 = (((f32(_e5733) + 0.5f) * _e5679) - 0.5f);
if _e453 {
phi_13836_ = type_23(_e5733, _e5727);
} else {
phi_13836_ = type_23(_e5727, _e5733);
}
let _e5747 = phi_13836_;
let _e5750 = (_e988 == 0u);
if _e5750 {
phi_13887_ = 0u;
} else {
if (_e988 == 1u) {
phi_13886_ = 0u;
} else {
if (_e988 == 2u) {
phi_13885_ = _e5071;
} else {
phi_13885_ = select(_e5077, _e5074, (_e988 == 3u));
}
let _e5756 = phi_13885_;
phi_13886_ = _e5756;
}
let _e5758 = phi_13886_;
phi_13887_ = _e5758;
}
let _e5760 = phi_13887_;
local_168 = (((bitcast<i32>(_e5760) + _e5747.member_1) * _e5068) + _e5747.member);
let _e5765 = local_168;
let _e5767 = select(_e5094, _e5765, (_e5765 < _e5094));
let _e5772 = global_6.member[bitcast<u32>(select(0i, _e5767, (_e5767 > 0i)))];
let _e5777 = (((((select(_e5737, _e5741, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e5782 = ((1f - (((select(_e5741, _e5737, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e5789 = ((_e4223.member * _e5777) + (_e4231.member * _e5782));
let _e5790 = ((_e4223.member_1 * _e5777) + (_e4231.member_1 * _e5782));
let _e5791 = ((_e4223.member_2 * _e5777) + (_e4231.member_2 * _e5782));
let _e5795 = select((_e4246.member + _e5789), _e4246.member, _e4244);
let _e5796 = select((_e4246.member_1 + _e5790), _e4246.member_1, _e4244);
let _e5797 = select((_e4246.member_2 + _e5791), _e4246.member_2, _e4244);
let _e5808 = (((_e5795 * _e5795) + (_e5796 * _e5796)) + (_e5797 * _e5797));
let _e5812 = (1f / sqrt(select(0f, _e5808, (_e5808 > 0f))));
let _e5813 = (_e5795 * _e5812);
let _e5814 = (_e5796 * _e5812);
let _e5815 = (_e5797 * _e5812);
let _e5816 = (_e575 - select(_e4257.member, (_e4257.member + _e5789), _e4244));
let _e5817 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e5790), _e4244));
let _e5818 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e5791), _e4244));
let _e5823 = (((_e5816 * _e5813) + (_e5817 * _e5814)) + (_e5818 * _e5815));
let _e5828 = (((_e5816 * _e613) + (_e5817 * _e626)) + (_e5818 * _e639));
let _e5833 = (((_e5813 * _e613) + (_e5814 * _e626)) + (_e5815 * _e639));
let _e5836 = ((_e5814 * _e639) - (_e5815 * _e626));
let _e5839 = ((_e5815 * _e613) - (_e5813 * _e639));
let _e5842 = ((_e5813 * _e626) - (_e5814 * _e613));
let _e5847 = (((_e5836 * _e5836) + (_e5839 * _e5839)) + (_e5842 * _e5842));
let _e5850 = (1f / select(1e-9f, _e5847, (_e5847 > 1e-9f)));
let _e5853 = ((_e5823 - (_e5833 * _e5828)) * _e5850);
let _e5856 = (((_e5833 * _e5823) - _e5828) * _e5850);
let _e5862 = select(0f, _e5853, (((_e5856 >= 0f) && (_e5856 < _e691)) && (_e5853 > 0f)));
let _e5864 = (_e5727 << bitcast<u32>(_e5658));
let _e5876 = (_e5699 + 1i);
let _e5879 = select(_e5876, 0i, (_e5876 < 0i));
let _e5880 = (_e5879 >= _e5674.member);
if _e5880 {
phi_14548_ = (_e5674.member - 1i);
} else {
phi_14548_ = _e5879;
}
let _e5883 = phi_14548_;
if _e5730 {
phi_14559_ = (_e5674.member_1 - 1i);
} else {
phi_14559_ = _e5729;
}
let _e5886 = phi_14559_;
let _e5890 = (((f32(_e5883) + 0.5f) * _e5679) - 0.5f);
let _e5894 = (((f32(_e5886) + 0.5f) * _e5679) - 0.5f);
if _e453 {
phi_14587_ = type_23(_e5886, _e5883);
} else {
phi_14587_ = type_23(_e5883, _e5886);
}
let _e5900 = phi_14587_;
if _e5750 {
phi_14638_ = 0u;
} else {
if (_e988 == 1u) {
phi_14637_ = 0u;
} else {
if (_e988 == 2u) {
phi_14636_ = _e5071;
} else {
phi_14636_ = select(_e5077, _e5074, (_e988 == 3u));
}
let _e5908 = phi_14636_;
phi_14637_ = _e5908;
}
let _e5910 = phi_14637_;
phi_14638_ = _e5910;
}
let _e5912 = phi_14638_;
local_166 = (((bitcast<i32>(_e5912) + _e5900.member_1) * _e5068) + _e5900.member);
let _e5917 = local_166;
let _e5919 = select(_e5094, _e5917, (_e5917 < _e5094));
let _e5924 = global_6.member[bitcast<u32>(select(0i, _e5919, (_e5919 > 0i)))];
let _e5929 = (((((select(_e5890, _e5894, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e5934 = ((1f - (((select(_e5894, _e5890, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e5941 = ((_e4223.member * _e5929) + (_e4231.member * _e5934));
let _e5942 = ((_e4223.member_1 * _e5929) + (_e4231.member_1 * _e5934));
let _e5943 = ((_e4223.member_2 * _e5929) + (_e4231.member_2 * _e5934));
let _e5947 = select((_e4246.member + _e5941), _e4246.member, _e4244);
let _e5948 = select((_e4246.member_1 + _e5942), _e4246.member_1, _e4244);
let _e5949 = select((_e4246.member_2 + _e5943), _e4246.member_2, _e4244);
let _e5960 = (((_e5947 * _e5947) + (_e5948 * _e5948)) + (_e5949 * _e5949));
let _e5964 = (1f / sqrt(select(0f, _e5960, (_e5960 > 0f))));
let _e5965 = (_e5947 * _e5964);
let _e5966 = (_e5948 * _e5964);
let _e5967 = (_e5949 * _e5964);
let _e5968 = (_e575 - select(_e4257.member, (_e4257.member + _e5941), _e4244));
let _e5969 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e5942), _e4244));
let _e5970 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e5943), _e4244));
let _e5975 = (((_e5968 * _e5965) + (_e5969 * _e5966)) + (_e5970 * _e5967));
let _e5980 = (((_e5968 * _e613) + (_e5969 * _e626)) + (_e5970 * _e639));
let _e5985 = (((_e5965 * _e613) + (_e5966 * _e626)) + (_e5967 * _e639));
let _e5988 = ((_e5966 * _e639) - (_e5967 * _e626));
let _e5991 = ((_e5967 * _e613) - (_e5965 * _e639));
let _e5994 = ((_e5965 * _e626) - (_e5966 * _e613));
let _e5999 = (((_e5988 * _e5988) + (_e5991 * _e5991)) + (_e5994 * _e5994));
let _e6002 = (1f / select(1e-9f, _e5999, (_e5999 > 1e-9f)));
let _e6005 = ((_e5975 - (_e5985 * _e5980)) * _e6002);
let _e6008 = (((_e5985 * _e5975) - _e5980) * _e6002);
let _e6014 = select(0f, _e6005, (((_e6008 >= 0f) && (_e6008 < _e691)) && (_e6005 > 0f)));
let _e6016 = (_e5883 << bitcast<u32>(_e5658));
let _e6028 = (_e5714 + 1i);
if _e5724 {
phi_15299_ = (_e5674.member - 1i);
} else {
phi_15299_ = _e5723;
}
let _e6032 = phi_15299_;
let _e6034 = select(_e6028, 0i, (_e6028 < 0i));
let _e6035 = (_e6034 >= _e5674.member_1);
if _e6035 {
phi_15310_ = (_e5674.member_1 - 1i);
} else {
phi_15310_ = _e6034;
}
let _e6038 = phi_15310_;
let _e6042 = (((f32(_e6032) + 0.5f) * _e5679) - 0.5f);
let _e6046 = (((f32(_e6038) + 0.5f) * _e5679) - 0.5f);
if _e453 {
phi_15338_ = type_23(_e6038, _e6032);
} else {
phi_15338_ = type_23(_e6032, _e6038);
}
let _e6052 = phi_15338_;
if _e5750 {
phi_15389_ = 0u;
} else {
if (_e988 == 1u) {
phi_15388_ = 0u;
} else {
if (_e988 == 2u) {
phi_15387_ = _e5071;
} else {
phi_15387_ = select(_e5077, _e5074, (_e988 == 3u));
}
let _e6060 = phi_15387_;
phi_15388_ = _e6060;
}
let _e6062 = phi_15388_;
phi_15389_ = _e6062;
}
let _e6064 = phi_15389_;
local_164 = (((bitcast<i32>(_e6064) + _e6052.member_1) * _e5068) + _e6052.member);
let _e6069 = local_164;
let _e6071 = select(_e5094, _e6069, (_e6069 < _e5094));
let _e6076 = global_6.member[bitcast<u32>(select(0i, _e6071, (_e6071 > 0i)))];
let _e6081 = (((((select(_e6042, _e6046, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e6086 = ((1f - (((select(_e6046, _e6042, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e6093 = ((_e4223.member * _e6081) + (_e4231.member * _e6086));
let _e6094 = ((_e4223.member_1 * _e6081) + (_e4231.member_1 * _e6086));
let _e6095 = ((_e4223.member_2 * _e6081) + (_e4231.member_2 * _e6086));
let _e6099 = select((_e4246.member + _e6093), _e4246.member, _e4244);
let _e6100 = select((_e4246.member_1 + _e6094), _e4246.member_1, _e4244);
let _e6101 = select((_e4246.member_2 + _e6095), _e4246.member_2, _e4244);
let _e6112 = (((_e6099 * _e6099) + (_e6100 * _e6100)) + (_e6101 * _e6101));
let _e6116 = (1f / sqrt(select(0f, _e6112, (_e6112 > 0f))));
let _e6117 = (_e6099 * _e6116);
let _e6118 = (_e6100 * _e6116);
let _e6119 = (_e6101 * _e6116);
let _e6120 = (_e575 - select(_e4257.member, (_e4257.member + _e6093), _e4244));
let _e6121 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e6094), _e4244));
let _e6122 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e6095), _e4244));
let _e6127 = (((_e6120 * _e6117) + (_e6121 * _e6118)) + (_e6122 * _e6119));
let _e6132 = (((_e6120 * _e613) + (_e6121 * _e626)) + (_e6122 * _e639));
let _e6137 = (((_e6117 * _e613) + (_e6118 * _e626)) + (_e6119 * _e639));
let _e6140 = ((_e6118 * _e639) - (_e6119 * _e626));
let _e6143 = ((_e6119 * _e613) - (_e6117 * _e639));
let _e6146 = ((_e6117 * _e626) - (_e6118 * _e613));
let _e6151 = (((_e6140 * _e6140) + (_e6143 * _e6143)) + (_e6146 * _e6146));
let _e6154 = (1f / select(1e-9f, _e6151, (_e6151 > 1e-9f)));
let _e6157 = ((_e6127 - (_e6137 * _e6132)) * _e6154);
let _e6160 = (((_e6137 * _e6127) - _e6132) * _e6154);
let _e6166 = select(0f, _e6157, (((_e6160 >= 0f) && (_e6160 < _e691)) && (_e6157 > 0f)));
let _e6168 = (_e6032 << bitcast<u32>(_e5658));
if _e5880 {
phi_16050_ = (_e5674.member - 1i);
} else {
phi_16050_ = _e5879;
}
let _e6183 = phi_16050_;
if _e6035 {
phi_16061_ = (_e5674.member_1 - 1i);
} else {
phi_16061_ = _e6034;
}
let _e6186 = phi_16061_;
let _e6190 = (((f32(_e6183) + 0.5f) * _e5679) - 0.5f);
let _e6194 = (((f32(_e6186) + 0.5f) * _e5679) - 0.5f);
if _e453 {
phi_16089_ = type_23(_e6186, _e6183);
} else {
phi_16089_ = type_23(_e6183, _e6186);
}
let _e6200 = phi_16089_;
if _e5750 {
phi_16140_ = 0u;
} else {
if (_e988 == 1u) {
phi_16139_ = 0u;
} else {
if (_e988 == 2u) {
phi_16138_ = _e5071;
} else {
phi_16138_ = select(_e5077, _e5074, (_e988 == 3u));
}
let _e6208 = phi_16138_;
phi_16139_ = _e6208;
}
let _e6210 = phi_16139_;
phi_16140_ = _e6210;
}
let _e6212 = phi_16140_;
local_162 = (((bitcast<i32>(_e6212) + _e6200.member_1) * _e5068) + _e6200.member);
let _e6217 = local_162;
let _e6219 = select(_e5094, _e6217, (_e6217 < _e5094));
let _e6224 = global_6.member[bitcast<u32>(select(0i, _e6219, (_e6219 > 0i)))];
let _e6229 = (((((select(_e6190, _e6194, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e6234 = ((1f - (((select(_e6194, _e6190, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e6241 = ((_e4223.member * _e6229) + (_e4231.member * _e6234));
let _e6242 = ((_e4223.member_1 * _e6229) + (_e4231.member_1 * _e6234));
let _e6243 = ((_e4223.member_2 * _e6229) + (_e4231.member_2 * _e6234));
let _e6247 = select((_e4246.member + _e6241), _e4246.member, _e4244);
let _e6248 = select((_e4246.member_1 + _e6242), _e4246.member_1, _e4244);
let _e6249 = select((_e4246.member_2 + _e6243), _e4246.member_2, _e4244);
let _e6260 = (((_e6247 * _e6247) + (_e6248 * _e6248)) + (_e6249 * _e6249));
let _e6264 = (1f / sqrt(select(0f, _e6260, (_e6260 > 0f))));
let _e6265 = (_e6247 * _e6264);
let _e6266 = (_e6248 * _e6264);
let _e6267 = (_e6249 * _e6264);
let _e6268 = (_e575 - select(_e4257.member, (_e4257.member + _e6241), _e4244));
let _e6269 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e6242), _e4244));
let _e6270 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e6243), _e4244));
let _e6275 = (((_e6268 * _e6265) + (_e6269 * _e6266)) + (_e6270 * _e6267));
let _e6280 = (((_e6268 * _e613) + (_e6269 * _e626)) + (_e6270 * _e639));
let _e6285 = (((_e6265 * _e613) + (_e6266 * _e626)) + (_e6267 * _e639));
let _e6288 = ((_e6266 * _e639) - (_e6267 * _e626));
let _e6291 = ((_e6267 * _e613) - (_e6265 * _e639));
let _e6294 = ((_e6265 * _e626) - (_e6266 * _e613));
let _e6299 = (((_e6288 * _e6288) + (_e6291 * _e6291)) + (_e6294 * _e6294));
let _e6302 = (1f / select(1e-9f, _e6299, (_e6299 > 1e-9f)));
let _e6305 = ((_e6275 - (_e6285 * _e6280)) * _e6302);
let _e6308 = (((_e6285 * _e6275) - _e6280) * _e6302);
let _e6314 = select(0f, _e6305, (((_e6308 >= 0f) && (_e6308 < _e691)) && (_e6305 > 0f)));
let _e6316 = (_e6183 << bitcast<u32>(_e5658));
let _e6328 = select(((((_e5657 - select(0f, (_e5719 * _e5720), (((select(select(_e766, _e927, (_e5864 >= _e692)), _e847, (_e5864 < _e298)) == _e988) && (_e5862 > 0f)) && (_e5862 < _e5772)))) - select(0f, (_e5716 * _e5720), (((select(select(_e766, _e927, (_e6016 >= _e692)), _e847, (_e6016 < _e298)) == _e988) && (_e6014 > 0f)) && (_e6014 < _e5924)))) - select(0f, (_e5719 * _e5718), (((select(select(_e766, _e927, (_e6168 >= _e692)), _e847, (_e6168 < _e298)) == _e988) && (_e6166 > 0f)) && (_e6166 < _e6076)))) - select(0f, (_e5716 * _e5718), (((select(select(_e766, _e927, (_e6316 >= _e692)), _e847, (_e6316 < _e298)) == _e988) && (_e6314 > 0f)) && (_e6314 < _e6224)))), _e5657, _e5750);
let _e6329 = (_e992 & 31u);
let _e6331 = (1u << bitcast<u32>(_e6329));
let _e6340 = bitcast<i32>((((_e931 + _e6331) - 1u) >> bitcast<u32>(_e6329)));
let _e6341 = bitcast<i32>((((_e934 + _e6331) - 1u) >> bitcast<u32>(_e6329)));
if _e453 {
phi_16819_ = type_23(_e6341, _e6340);
} else {
phi_16819_ = type_23(_e6340, _e6341);
}
let _e6345 = phi_16819_;
let _e6350 = f32((1i << bitcast<u32>(_e6329)));
let _e6351 = (1f / _e6350);
let _e6353 = ((_e4019 * _e6351) - 0.5f);
let _e6355 = ((_e4112 * _e6351) - 0.5f);
let _e6357 = select(-1f, _e6353, (_e6353 > -1f));
let _e6359 = select(1e6f, _e6357, (_e6357 < 1e6f));
let _e6366 = select(0i, select(select(i32(_e6359), i32(-2147483648), (_e6359 < -2147483600f)), 2147483647i, (_e6359 > 2147483500f)), (_e6359 == _e6359));
let _e6370 = (_e6366 - select(0i, 1i, (_e6359 < f32(_e6366))));
let _e6372 = select(-1f, _e6355, (_e6355 > -1f));
let _e6374 = select(1e6f, _e6372, (_e6372 < 1e6f));
let _e6381 = select(0i, select(select(i32(_e6374), i32(-2147483648), (_e6374 < -2147483600f)), 2147483647i, (_e6374 > 2147483500f)), (_e6374 == _e6374));
let _e6385 = (_e6381 - select(0i, 1i, (_e6374 < f32(_e6381))));
let _e6387 = (_e6353 - f32(_e6370));
let _e6389 = (_e6355 - f32(_e6385));
let _e6390 = (1f - _e6387);
let _e6391 = (1f - _e6389);
let _e6394 = select(_e6370, 0i, (_e6370 < 0i));
let _e6395 = (_e6394 >= _e6345.member);
if _e6395 {
phi_16897_ = (_e6345.member - 1i);
} else {
phi_16897_ = _e6394;
}
let _e6398 = phi_16897_;
let _e6400 = select(_e6385, 0i, (_e6385 < 0i));
let _e6401 = (_e6400 >= _e6345.member_1);
if _e6401 {
phi_16908_ = (_e6345.member_1 - 1i);
} else {
phi_16908_ = _e6400;
}
let _e6404 = phi_16908_;
let _e6408 = (((f32(_e6398) + 0.5f) * _e6350) - 0.5f);
let _e6412 = (((f32(_e6404) + 0.5f) * _e6350) - 0.5f);
if _e453 {
phi_16936_ = type_23(_e6404, _e6398);
} else {
phi_16936_ = type_23(_e6398, _e6404);
}
let _e6418 = phi_16936_;
let _e6421 = (_e992 == 0u);
if _e6421 {
phi_16987_ = 0u;
} else {
if (_e992 == 1u) {
phi_16986_ = 0u;
} else {
if (_e992 == 2u) {
phi_16985_ = _e5071;
} else {
phi_16985_ = select(_e5077, _e5074, (_e992 == 3u));
}
let _e6427 = phi_16985_;
phi_16986_ = _e6427;
}
let _e6429 = phi_16986_;
phi_16987_ = _e6429;
}
let _e6431 = phi_16987_;
local_160 = (((bitcast<i32>(_e6431) + _e6418.member_1) * _e5068) + _e6418.member);
let _e6436 = local_160;
let _e6438 = select(_e5094, _e6436, (_e6436 < _e5094));
let _e6443 = global_6.member[bitcast<u32>(select(0i, _e6438, (_e6438 > 0i)))];
let _e6448 = (((((select(_e6408, _e6412, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e6453 = ((1f - (((select(_e6412, _e6408, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e6460 = ((_e4223.member * _e6448) + (_e4231.member * _e6453));
let _e6461 = ((_e4223.member_1 * _e6448) + (_e4231.member_1 * _e6453));
let _e6462 = ((_e4223.member_2 * _e6448) + (_e4231.member_2 * _e6453));
let _e6466 = select((_e4246.member + _e6460), _e4246.member, _e4244);
let _e6467 = select((_e4246.member_1 + _e6461), _e4246.member_1, _e4244);
let _e6468 = select((_e4246.member_2 + _e6462), _e4246.member_2, _e4244);
let _e6479 = (((_e6466 * _e6466) + (_e6467 * _e6467)) + (_e6468 * _e6468));
let _e6483 = (1f / sqrt(select(0f, _e6479, (_e6479 > 0f))));
let _e6484 = (_e6466 * _e6483);
let _e6485 = (_e6467 * _e6483);
let _e6486 = (_e6468 * _e6483);
let _e6487 = (_e575 - select(_e4257.member, (_e4257.member + _e6460), _e4244));
let _e6488 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e6461), _e4244));
let _e6489 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e6462), _e4244));
let _e6494 = (((_e6487 * _e6484) + (_e6488 * _e6485)) + (_e6489 * _e6486));
let _e6499 = (((_e6487 * _e613) + (_e6488 * _e626)) + (_e6489 * _e639));
let _e6504 = (((_e6484 * _e613) + (_e6485 * _e626)) + (_e6486 * _e639));
let _e6507 = ((_e6485 * _e639) - (_e6486 * _e626));
let _e6510 = ((_e6486 * _e613) - (_e6484 * _e639));
let _e6513 = ((_e6484 * _e626) - (_e6485 * _e613));
let _e6518 = (((_e6507 * _e6507) + (_e6510 * _e6510)) + (_e6513 * _e6513));
let _e6521 = (1f / select(1e-9f, _e6518, (_e6518 > 1e-9f)));
let _e6524 = ((_e6494 - (_e6504 * _e6499)) * _e6521);
let _e6527 = (((_e6504 * _e6494) - _e6499) * _e6521);
let _e6533 = select(0f, _e6524, (((_e6527 >= 0f) && (_e6527 < _e691)) && (_e6524 > 0f)));
let _e6535 = (_e6398 << bitcast<u32>(_e6329));
let _e6547 = (_e6370 + 1i);
let _e6550 = select(_e6547, 0i, (_e6547 < 0i));
let _e6551 = (_e6550 >= _e6345.member);
if _e6551 {
phi_17648_ = (_e6345.member - 1i);
} else {
phi_17648_ = _e6550;
}
let _e6554 = phi_17648_;
if _e6401 {
phi_17659_ = (_e6345.member_1 - 1i);
} else {
phi_17659_ = _e6400;
}
let _e6557 = phi_17659_;
let _e6561 = (((f32(_e6554) + 0.5f) * _e6350) - 0.5f);
let _e6565 = (((f32(_e6557) + 0.5f) * _e6350) - 0.5f);
if _e453 {
phi_17687_ = type_23(_e6557, _e6554);
} else {
phi_17687_ = type_23(_e6554, _e6557);
}
let _e6571 = phi_17687_;
if _e6421 {
phi_17738_ = 0u;
} else {
if (_e992 == 1u) {
phi_17737_ = 0u;
} else {
if (_e992 == 2u) {
phi_17736_ = _e5071;
} else {
phi_17736_ = select(_e5077, _e5074, (_e992 == 3u));
}
let _e6579 = phi_17736_;
phi_17737_ = _e6579;
}
let _e6581 = phi_17737_;
phi_17738_ = _e6581;
}
let _e6583 = phi_17738_;
local_158 = (((bitcast<i32>(_e6583) + _e6571.member_1) * _e5068) + _e6571.member);
let _e6588 = local_158;
let _e6590 = select(_e5094, _e6588, (_e6588 < _e5094));
let _e6595 = global_6.member[bitcast<u32>(select(0i, _e6590, (_e6590 > 0i)))];
let _e6600 = (((((select(_e6561, _e6565, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e6605 = ((1f - (((select(_e6565, _e6561, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e6612 = ((_e4223.member * _e6600) + (_e4231.member * _e6605));
let _e6613 = ((_e4223.member_1 * _e6600) + (_e4231.member_1 * _e6605));
let _e6614 = ((_e4223.member_2 * _e6600) + (_e4231.member_2 * _e6605));
let _e6618 = select((_e4246.member + _e6612), _e4246.member, _e4244);
let _e6619 = select((_e4246.member_1 + _e6613), _e4246.member_1, _e4244);
let _e6620 = select((_e4246.member_2 + _e6614), _e4246.member_2, _e4244);
let _e6631 = (((_e6618 * _e6618) + (_e6619 * _e6619)) + (_e6620 * _e6620));
let _e6635 = (1f / sqrt(select(0f, _e6631, (_e6631 > 0f))));
let _e6636 = (_e6618 * _e6635);
let _e6637 = (_e6619 * _e6635);
let _e6638 = (_e6620 * _e6635);
let _e6639 = (_e575 - select(_e4257.member, (_e4257.member + _e6612), _e4244));
let _e6640 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e6613), _e4244));
let _e6641 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e6614), _e4244));
let _e6646 = (((_e6639 * _e6636) + (_e6640 * _e6637)) + (_e6641 * _e6638));
let _e6651 = (((_e6639 * _e613) + (_e6640 * _e626)) + (_e6641 * _e639));
let _e6656 = (((_e6636 * _e613) + (_e6637 * _e626)) + (_e6638 * _e639));
let _e6659 = ((_e6637 * _e639) - (_e6638 * _e626));
let _e6662 = ((_e6638 * _e613) - (_e6636 * _e639));
let _e6665 = ((_e6636 * _e626) - (_e6637 * _e613));
let _e6670 = (((_e6659 * _e6659) + (_e6662 * _e6662)) + (_e6665 * _e6665));
let _e6673 = (1f / select(1e-9f, _e6670, (_e6670 > 1e-9f)));
let _e6676 = ((_e6646 - (_e6656 * _e6651)) * _e6673);
let _e6679 = (((_e6656 * _e6646) - _e6651) * _e6673);
let _e6685 = select(0f, _e6676, (((_e6679 >= 0f) && (_e6679 < _e691)) && (_e6676 > 0f)));
let _e6687 = (_e6554 << bitcast<u32>(_e6329));
let _e6699 = (_e6385 + 1i);
if _e6395 {
phi_18399_ = (_e6345.member - 1i);
} else {
phi_18399_ = _e6394;
}
let _e6703 = phi_18399_;
let _e6705 = select(_e6699, 0i, (_e6699 < 0i));
let _e6706 = (_e6705 >= _e6345.member_1);
if _e6706 {
phi_18410_ = (_e6345.member_1 - 1i);
} else {
phi_18410_ = _e6705;
}
let _e6709 = phi_18410_;
let _e6713 = (((f32(_e6703) + 0.5f) * _e6350) - 0.5f);
let _e6717 = (((f32(_e6709) + 0.5f) * _e6350) - 0.5f);
if _e453 {
phi_18438_ = type_23(_e6709, _e6703);
} else {
phi_18438_ = type_23(_e6703, _e6709);
}
let _e6723 = phi_18438_;
if _e6421 {
phi_18489_ = 0u;
} else {
if (_e992 == 1u) {
phi_18488_ = 0u;
} else {
if (_e992 == 2u) {
phi_18487_ = _e5071;
} else {
phi_18487_ = select(_e5077, _e5074, (_e992 == 3u));
}
let _e6731 = phi_18487_;
phi_18488_ = _e6731;
}
let _e6733 = phi_18488_;
phi_18489_ = _e6733;
}
let _e6735 = phi_18489_;
local_156 = (((bitcast<i32>(_e6735) + _e6723.member_1) * _e5068) + _e6723.member);
let _e6740 = local_156;
let _e6742 = select(_e5094, _e6740, (_e6740 < _e5094));
let _e6747 = global_6.member[bitcast<u32>(select(0i, _e6742, (_e6742 > 0i)))];
let _e6752 = (((((select(_e6713, _e6717, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e6757 = ((1f - (((select(_e6717, _e6713, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e6764 = ((_e4223.member * _e6752) + (_e4231.member * _e6757));
let _e6765 = ((_e4223.member_1 * _e6752) + (_e4231.member_1 * _e6757));
let _e6766 = ((_e4223.member_2 * _e6752) + (_e4231.member_2 * _e6757));
let _e6770 = select((_e4246.member + _e6764), _e4246.member, _e4244);
let _e6771 = select((_e4246.member_1 + _e6765), _e4246.member_1, _e4244);
let _e6772 = select((_e4246.member_2 + _e6766), _e4246.member_2, _e4244);
let _e6783 = (((_e6770 * _e6770) + (_e6771 * _e6771)) + (_e6772 * _e6772));
let _e6787 = (1f / sqrt(select(0f, _e6783, (_e6783 > 0f))));
let _e6788 = (_e6770 * _e6787);
let _e6789 = (_e6771 * _e6787);
let _e6790 = (_e6772 * _e6787);
let _e6791 = (_e575 - select(_e4257.member, (_e4257.member + _e6764), _e4244));
let _e6792 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e6765), _e4244));
let _e6793 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e6766), _e4244));
let _e6798 = (((_e6791 * _e6788) + (_e6792 * _e6789)) + (_e6793 * _e6790));
let _e6803 = (((_e6791 * _e613) + (_e6792 * _e626)) + (_e6793 * _e639));
let _e6808 = (((_e6788 * _e613) + (_e6789 * _e626)) + (_e6790 * _e639));
let _e6811 = ((_e6789 * _e639) - (_e6790 * _e626));
let _e6814 = ((_e6790 * _e613) - (_e6788 * _e639));
let _e6817 = ((_e6788 * _e626) - (_e6789 * _e613));
let _e6822 = (((_e6811 * _e6811) + (_e6814 * _e6814)) + (_e6817 * _e6817));
let _e6825 = (1f / select(1e-9f, _e6822, (_e6822 > 1e-9f)));
let _e6828 = ((_e6798 - (_e6808 * _e6803)) * _e6825);
let _e6831 = (((_e6808 * _e6798) - _e6803) * _e6825);
let _e6837 = select(0f, _e6828, (((_e6831 >= 0f) && (_e6831 < _e691)) && (_e6828 > 0f)));
let _e6839 = (_e6703 << bitcast<u32>(_e6329));
if _e6551 {
phi_19150_ = (_e6345.member - 1i);
} else {
phi_19150_ = _e6550;
}
let _e6854 = phi_19150_;
if _e6706 {
phi_19161_ = (_e6345.member_1 - 1i);
} else {
phi_19161_ = _e6705;
}
let _e6857 = phi_19161_;
let _e6861 = (((f32(_e6854) + 0.5f) * _e6350) - 0.5f);
let _e6865 = (((f32(_e6857) + 0.5f) * _e6350) - 0.5f);
if _e453 {
phi_19189_ = type_23(_e6857, _e6854);
} else {
phi_19189_ = type_23(_e6854, _e6857);
}
let _e6871 = phi_19189_;
if _e6421 {
phi_19240_ = 0u;
} else {
if (_e992 == 1u) {
phi_19239_ = 0u;
} else {
if (_e992 == 2u) {
phi_19238_ = _e5071;
} else {
phi_19238_ = select(_e5077, _e5074, (_e992 == 3u));
}
let _e6879 = phi_19238_;
phi_19239_ = _e6879;
}
let _e6881 = phi_19239_;
phi_19240_ = _e6881;
}
let _e6883 = phi_19240_;
local_154 = (((bitcast<i32>(_e6883) + _e6871.member_1) * _e5068) + _e6871.member);
let _e6888 = local_154;
let _e6890 = select(_e5094, _e6888, (_e6888 < _e5094));
let _e6895 = global_6.member[bitcast<u32>(select(0i, _e6890, (_e6890 > 0i)))];
let _e6900 = (((((select(_e6861, _e6865, _e453) + 0.5f) / _e4204) * 2f) - 1f) * _e4212);
let _e6905 = ((1f - (((select(_e6865, _e6861, _e453) + 0.5f) / _e4205) * 2f)) * _e4220);
let _e6912 = ((_e4223.member * _e6900) + (_e4231.member * _e6905));
let _e6913 = ((_e4223.member_1 * _e6900) + (_e4231.member_1 * _e6905));
let _e6914 = ((_e4223.member_2 * _e6900) + (_e4231.member_2 * _e6905));
let _e6918 = select((_e4246.member + _e6912), _e4246.member, _e4244);
let _e6919 = select((_e4246.member_1 + _e6913), _e4246.member_1, _e4244);
let _e6920 = select((_e4246.member_2 + _e6914), _e4246.member_2, _e4244);
let _e6931 = (((_e6918 * _e6918) + (_e6919 * _e6919)) + (_e6920 * _e6920));
let _e6935 = (1f / sqrt(select(0f, _e6931, (_e6931 > 0f))));
let _e6936 = (_e6918 * _e6935);
let _e6937 = (_e6919 * _e6935);
let _e6938 = (_e6920 * _e6935);
let _e6939 = (_e575 - select(_e4257.member, (_e4257.member + _e6912), _e4244));
let _e6940 = (_e587 - select(_e4257.member_1, (_e4257.member_1 + _e6913), _e4244));
let _e6941 = (_e600 - select(_e4257.member_2, (_e4257.member_2 + _e6914), _e4244));
let _e6946 = (((_e6939 * _e6936) + (_e6940 * _e6937)) + (_e6941 * _e6938));
let _e6951 = (((_e6939 * _e613) + (_e6940 * _e626)) + (_e6941 * _e639));
let _e6956 = (((_e6936 * _e613) + (_e6937 * _e626)) + (_e6938 * _e639));
let _e6959 = ((_e6937 * _e639) - (_e6938 * _e626));
let _e6962 = ((_e6938 * _e613) - (_e6936 * _e639));
let _e6965 = ((_e6936 * _e626) - (_e6937 * _e613));
let _e6970 = (((_e6959 * _e6959) + (_e6962 * _e6962)) + (_e6965 * _e6965));
let _e6973 = (1f / select(1e-9f, _e6970, (_e6970 > 1e-9f)));
let _e6976 = ((_e6946 - (_e6956 * _e6951)) * _e6973);
let _e6979 = (((_e6956 * _e6946) - _e6951) * _e6973);
let _e6985 = select(0f, _e6976, (((_e6979 >= 0f) && (_e6979 < _e691)) && (_e6976 > 0f)));
let _e6987 = (_e6854 << bitcast<u32>(_e6329));
let _e6999 = select(((((_e6328 - select(0f, (_e6390 * _e6391), (((select(select(_e766, _e927, (_e6535 >= _e692)), _e847, (_e6535 < _e298)) == _e992) && (_e6533 > 0f)) && (_e6533 < _e6443)))) - select(0f, (_e6387 * _e6391), (((select(select(_e766, _e927, (_e6687 >= _e692)), _e847, (_e6687 < _e298)) == _e992) && (_e6685 > 0f)) && (_e6685 < _e6595)))) - select(0f, (_e6390 * _e6389), (((select(select(_e766, _e927, (_e6839 >= _e692)), _e847, (_e6839 < _e298)) == _e992) && (_e6837 > 0f)) && (_e6837 < _e6747)))) - select(0f, (_e6387 * _e6389), (((select(select(_e766, _e927, (_e6987 >= _e692)), _e847, (_e6987 < _e298)) == _e992) && (_e6985 > 0f)) && (_e6985 < _e6895)))), _e6328, _e6421);
if _e453 {
phi_19910_ = type_23(_e4109, _e4017);
} else {
phi_19910_ = type_23(_e4017, _e4109);
}
let _e7014 = phi_19910_;
let _e7017 = (_e4110 && (((_e4972 > 0f) && (_e4972 < _e4200)) && (bitcast<f32>((bitcast<u32>(_e6999) & 2147483647u)) > 1e-6f)));
let _e7020 = global_1.member.member_18.member;
let _e7021 = (((select(_e4135, (1f - _e4135), (_e4120 >= 0f)) - select(_e4154, (1f - _e4154), (_e4139 >= 0f))) * (1f / _e4117)) * _e7020);
let _e7025 = select(0f, (((((_e652 * _e4809.member) * ((1f + (_e4849 * (1f + (_e4849 * (0.5f + (_e4849 * (0.16666667f + (_e4849 * (0.041666668f + (_e4849 * (0.008333334f + (_e4849 * (0.001388889f + (_e4849 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4844 + 127i)) << bitcast<u32>(23i))))) * _e4806) * _e6999) * _e7021), _e7017);
let _e7026 = select(0f, (((((_e665 * _e4809.member_1) * ((1f + (_e4897 * (1f + (_e4897 * (0.5f + (_e4897 * (0.16666667f + (_e4897 * (0.041666668f + (_e4897 * (0.008333334f + (_e4897 * (0.001388889f + (_e4897 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4892 + 127i)) << bitcast<u32>(23i))))) * _e4806) * _e6999) * _e7021), _e7017);
let _e7027 = select(0f, (((((_e678 * _e4809.member_2) * ((1f + (_e4945 * (1f + (_e4945 * (0.5f + (_e4945 * (0.16666667f + (_e4945 * (0.041666668f + (_e4945 * (0.008333334f + (_e4945 * (0.001388889f + (_e4945 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4940 + 127i)) << bitcast<u32>(23i))))) * _e4806) * _e6999) * _e7021), _e7017);
let _e7031 = (bitcast<f32>((bitcast<u32>(_e7025) & 2147483647u)) >= 1073741800f);
let _e7032 = (1f / 1048576f);
let _e7035 = ((_e7025 * select(1f, _e7032, _e7031)) + 0.5f);
let _e7037 = select(-1073741800f, _e7035, (_e7035 > -1073741800f));
let _e7039 = select(1073741800f, _e7037, (_e7037 < 1073741800f));
let _e7046 = select(0i, select(select(i32(_e7039), i32(-2147483648), (_e7039 < -2147483600f)), 2147483647i, (_e7039 > 2147483500f)), (_e7039 == _e7039));
let _e7050 = (_e7046 - select(0i, 1i, (_e7039 < f32(_e7046))));
let _e7051 = select(0i, 20i, _e7031);
let _e7055 = (bitcast<u32>(_e7050) << bitcast<u32>((_e7051 & 31i)));
let _e7062 = bitcast<u32>(((_e7050 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e7051) & 31i))));
let _e7066 = (bitcast<f32>((bitcast<u32>(_e7026) & 2147483647u)) >= 1073741800f);
let _e7069 = ((_e7026 * select(1f, _e7032, _e7066)) + 0.5f);
let _e7071 = select(-1073741800f, _e7069, (_e7069 > -1073741800f));
let _e7073 = select(1073741800f, _e7071, (_e7071 < 1073741800f));
let _e7080 = select(0i, select(select(i32(_e7073), i32(-2147483648), (_e7073 < -2147483600f)), 2147483647i, (_e7073 > 2147483500f)), (_e7073 == _e7073));
let _e7084 = (_e7080 - select(0i, 1i, (_e7073 < f32(_e7080))));
let _e7085 = select(0i, 20i, _e7066);
let _e7089 = (bitcast<u32>(_e7084) << bitcast<u32>((_e7085 & 31i)));
let _e7096 = bitcast<u32>(((_e7084 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e7085) & 31i))));
let _e7100 = (bitcast<f32>((bitcast<u32>(_e7027) & 2147483647u)) >= 1073741800f);
let _e7103 = ((_e7027 * select(1f, _e7032, _e7100)) + 0.5f);
let _e7105 = select(-1073741800f, _e7103, (_e7103 > -1073741800f));
let _e7107 = select(1073741800f, _e7105, (_e7105 < 1073741800f));
let _e7114 = select(0i, select(select(i32(_e7107), i32(-2147483648), (_e7107 < -2147483600f)), 2147483647i, (_e7107 > 2147483500f)), (_e7107 == _e7107));
let _e7118 = (_e7114 - select(0i, 1i, (_e7107 < f32(_e7114))));
let _e7119 = select(0i, 20i, _e7100);
let _e7123 = (bitcast<u32>(_e7118) << bitcast<u32>((_e7119 & 31i)));
let _e7130 = bitcast<u32>(((_e7118 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e7119) & 31i))));
let _e7135 = bitcast<i32>(bitcast<u32>((((_e7014.member_1 * _e935) + _e7014.member) * 6i)));
if ((_e7055 | _e7062) == 0u) {
} else {
let _e7138 = bitcast<u32>(_e7135);
if (_e7138 < _e270) {
let _e7142 = atomicAdd((&global_8.member[_e7138]), _e7055);
phi_20143_ = _e7142;
} else {
phi_20143_ = 0u;
}
let _e7144 = phi_20143_;
let _e7148 = (_e7062 + select(0u, 1u, ((_e7144 + _e7055) < _e7055)));
if (_e7148 == 0u) {
} else {
let _e7150 = (_e7138 + 1u);
if (_e7150 < _e270) {
let _e7154 = atomicAdd((&global_8.member[_e7150]), _e7148);
}
}
}
if ((_e7089 | _e7096) == 0u) {
} else {
let _e7158 = bitcast<u32>((_e7135 + 2i));
if (_e7158 < _e270) {
let _e7162 = atomicAdd((&global_8.member[_e7158]), _e7089);
phi_20173_ = _e7162;
} else {
phi_20173_ = 0u;
}
let _e7164 = phi_20173_;
let _e7168 = (_e7096 + select(0u, 1u, ((_e7164 + _e7089) < _e7089)));
if (_e7168 == 0u) {
} else {
let _e7170 = (_e7158 + 1u);
if (_e7170 < _e270) {
let _e7174 = atomicAdd((&global_8.member[_e7170]), _e7168);
}
}
}
if ((_e7123 | _e7130) == 0u) {
} else {
let _e7178 = bitcast<u32>((_e7135 + 4i));
if (_e7178 < _e270) {
let _e7182 = atomicAdd((&global_8.member[_e7178]), _e7123);
phi_20203_ = _e7182;
} else {
phi_20203_ = 0u;
}
let _e7184 = phi_20203_;
let _e7188 = (_e7130 + select(0u, 1u, ((_e7184 + _e7123) < _e7123)));
if (_e7188 == 0u) {
} else {
let _e7190 = (_e7178 + 1u);
if (_e7190 < _e270) {
let _e7194 = atomicAdd((&global_8.member[_e7190]), _e7188);
}
}
}
phi_9221_ = (_e4107 + 1i);
} else {
phi_9221_ = i32();
}
let _e7197 = phi_9221_;
continue;
continuing {
phi_9220_ = _e7197;
break if !(_e4110);
}
}
phi_9067_ = (_e4014 + 1i);
} else {
phi_9067_ = i32();
}
let _e7201 = phi_9067_;
continue;
continuing {
phi_9066_ = _e7201;
break if !(_e4015);
}
}
}
}
} else {
let _e7203 = (_e766 & 31u);
let _e7205 = (1u << bitcast<u32>(_e7203));
let _e7214 = bitcast<i32>((((_e931 + _e7205) - 1u) >> bitcast<u32>(_e7203)));
let _e7215 = bitcast<i32>((((_e934 + _e7205) - 1u) >> bitcast<u32>(_e7203)));
if _e453 {
phi_20269_ = type_23(_e7215, _e7214);
} else {
phi_20269_ = type_23(_e7214, _e7215);
}
let _e7219 = phi_20269_;
let _e7223 = (_e961 >> bitcast<u32>(_e7203));
if (_e7223 < _e7219.member) {
phi_20344_ = _e7223;
} else {
phi_20344_ = (_e7219.member - 1i);
}
let _e7229 = phi_20344_;
phi_20348_ = type_23(2147483647i, -1i);
phi_20351_ = 0i;
loop {
let _e7232 = phi_20348_;
let _e7234 = phi_20351_;
local_231 = _e7232;
local_232 = _e7232;
let _e7235 = (_e7234 < 16i);
if _e7235 {
let _e7237 = (1i << bitcast<u32>(_e7203));
let _e7238 = f32(_e7237);
let _e7240 = ((4u - _e766) & 31u);
let _e7245 = ((_e979 >> bitcast<u32>(_e7203)) + (_e7234 & ((1i << bitcast<u32>(_e7240)) - 1i)));
let _e7249 = (((f32(_e7245) + 0.5f) * _e7238) - 0.5f);
let _e7253 = (-(((_e416 * _e7249) + _e442)) / _e429);
let _e7260 = bitcast<f32>((bitcast<u32>(((_e466 * _e7249) + ((_e479 * _e7253) + _e492))) & 2147483647u));
let _e7267 = bitcast<f32>((bitcast<u32>(((_e505 * _e7249) + ((_e518 * _e7253) + _e531))) & 2147483647u));
let _e7272 = (((0.5f * (_e7260 + _e7267)) / _e534) + (0.5f * _e7238));
let _e7273 = (1f / _e7238);
let _e7281 = ((((_e7253 + _e7272) + 0.5f) * _e7273) - 0.5f);
let _e7282 = f32((_e7219.member_1 - 1i));
let _e7283 = (0f - 1f);
let _e7285 = select(_e7283, _e7281, (_e7281 > _e7283));
let _e7287 = select(_e7282, _e7285, (_e7285 < _e7282));
let _e7294 = select(0i, select(select(i32(_e7287), i32(-2147483648), (_e7287 < -2147483600f)), 2147483647i, (_e7287 > 2147483500f)), (_e7287 == _e7287));
let _e7299 = (((((_e7253 - _e7272) + 0.5f) * _e7273) - 0.5f) + 1f);
let _e7300 = (_e7282 + 1f);
let _e7302 = select(0f, _e7299, (_e7299 > 0f));
let _e7304 = select(_e7300, _e7302, (_e7302 < _e7300));
let _e7311 = select(0i, select(select(i32(_e7304), i32(-2147483648), (_e7304 < -2147483600f)), 2147483647i, (_e7304 > 2147483500f)), (_e7304 == _e7304));
let _e7322 = ((1e-4f * _e7238) * _e534);
let _e7324 = select(_e7267, _e7260, (_e7260 > _e7267));
let _e7326 = select(_e7322, _e7324, (_e7324 > _e7322));
let _e7328 = select(_e7267, _e7260, (_e7260 < _e7267));
let _e7330 = select(_e7322, _e7328, (_e7328 > _e7322));
let _e7332 = (0.5f * (_e7326 + _e7330));
let _e7333 = (0.5f / _e7330);
let _e7334 = (1f / _e7326);
phi_20502_ = _e7232;
phi_20505_ = 0i;
loop {
let _e7336 = phi_20502_;
let _e7338 = phi_20505_;
local_241 = _e7336;
let _e7341 = (((_e7311 - select(0i, 1i, (_e7304 < f32(_e7311)))) + (_e7234 >> bitcast<u32>(_e7240))) + (_e7338 << bitcast<u32>(_e7203)));
let _e7342 = (_e7341 <= select(-1i, (_e7294 - select(0i, 1i, (_e7287 < f32(_e7294)))), (_e7245 <= _e7229)));
if _e7342 {
let _e7346 = (((f32(_e7341) + 0.5f) * _e7238) - 0.5f);
let _e7348 = ((_e7346 - _e7253) * _e534);
let _e7349 = (_e534 * _e7238);
let _e7351 = (0.5f * _e7349);
let _e7352 = (_e7348 + _e7351);
let _e7353 = -(_e7352);
let _e7356 = (_e7332 - select(_e7353, _e7352, (_e7352 > _e7353)));
let _e7358 = select(0f, _e7356, (_e7356 > 0f));
let _e7360 = select(_e7330, _e7358, (_e7358 < _e7330));
let _e7363 = (_e7356 - _e7330);
let _e7367 = (((_e7360 * (_e7360 * _e7333)) + select(0f, _e7363, (_e7363 > 0f))) * _e7334);
let _e7371 = (_e7348 - _e7351);
let _e7372 = -(_e7371);
let _e7375 = (_e7332 - select(_e7372, _e7371, (_e7371 > _e7372)));
let _e7377 = select(0f, _e7375, (_e7375 > 0f));
let _e7379 = select(_e7330, _e7377, (_e7377 < _e7330));
let _e7382 = (_e7375 - _e7330);
let _e7386 = (((_e7379 * (_e7379 * _e7333)) + select(0f, _e7382, (_e7382 > 0f))) * _e7334);
if _e453 {
phi_20635_ = type_23(_e7341, _e7245);
} else {
phi_20635_ = type_23(_e7245, _e7341);
}
let _e7397 = phi_20635_;
let _e7403 = bitcast<i32>(((_e931 + 1u) >> bitcast<u32>(1u)));
let _e7406 = global_1.member.member_18.member_9;
let _e7411 = global_1.member.member_18.member_6;
let _e7414 = global_1.member.member_18.member_7;
let _e7417 = global_1.member.member_18.member_8;
if _e986 {
phi_20686_ = 0u;
} else {
if (_e766 == 1u) {
phi_20685_ = 0u;
} else {
if (_e766 == 2u) {
phi_20684_ = _e7411;
} else {
phi_20684_ = select(_e7417, _e7414, (_e766 == 3u));
}
let _e7423 = phi_20684_;
phi_20685_ = _e7423;
}
let _e7425 = phi_20685_;
phi_20686_ = _e7425;
}
let _e7427 = phi_20686_;
local_152 = (((bitcast<i32>(_e7427) + _e7397.member_1) * _e7403) + _e7397.member);
local_153 = (_e7403 * bitcast<i32>(_e7406));
let _e7432 = local_152;
let _e7434 = (bitcast<i32>(_e262) - 1i);
let _e7436 = select(_e7434, _e7432, (_e7432 < _e7434));
let _e7441 = global_6.member[bitcast<u32>(select(0i, _e7436, (_e7436 > 0i)))];
let _e7442 = local_153;
let _e7443 = local_152;
let _e7444 = (_e7442 + _e7443);
let _e7446 = select(_e7434, _e7444, (_e7444 < _e7434));
let _e7451 = global_6.member[bitcast<u32>(select(0i, _e7446, (_e7446 > 0i)))];
let _e7452 = local_153;
let _e7454 = local_152;
let _e7455 = ((2i * _e7452) + _e7454);
let _e7457 = select(_e7434, _e7455, (_e7455 < _e7434));
let _e7462 = global_6.member[bitcast<u32>(select(0i, _e7457, (_e7457 > 0i)))];
let _e7464 = (_e7237 >> bitcast<u32>(1i));
let _e7467 = ((_e7397.member << bitcast<u32>(_e7203)) + _e7464);
let _e7470 = ((_e7397.member_1 << bitcast<u32>(_e7203)) + _e7464);
let _e7472 = select(_e7467, 0i, (_e7467 < 0i));
if (_e7472 >= _e935) {
phi_20812_ = (_e935 - 1i);
} else {
phi_20812_ = _e7472;
}
let _e7476 = phi_20812_;
let _e7478 = select(_e7470, 0i, (_e7470 < 0i));
if (_e7478 >= _e936) {
phi_20823_ = (_e936 - 1i);
} else {
phi_20823_ = _e7478;
}
let _e7482 = phi_20823_;
let _e7484 = bitcast<i32>((_e931 * _e934));
local_150 = _e7484;
local_151 = ((_e7482 * _e935) + _e7476);
let _e7487 = local_150;
let _e7488 = local_151;
let _e7489 = (_e7487 + _e7488);
let _e7491 = (bitcast<i32>(_e259) - 1i);
let _e7493 = select(_e7491, _e7489, (_e7489 < _e7491));
let _e7498 = global_5.member[bitcast<u32>(select(0i, _e7493, (_e7493 > 0i)))];
let _e7499 = local_150;
let _e7501 = local_151;
let _e7502 = ((2i * _e7499) + _e7501);
let _e7504 = select(_e7491, _e7502, (_e7502 < _e7491));
let _e7509 = global_5.member[bitcast<u32>(select(0i, _e7504, (_e7504 > 0i)))];
let _e7510 = local_151;
let _e7519 = global_1.member.member_2.member;
let _e7520 = (((((select(_e7249, _e7346, _e453) + 0.5f) / f32(_e935)) * 2f) - 1f) * _e7519);
let _e7527 = global_1.member.member_2.member_1;
let _e7528 = ((1f - (((select(_e7346, _e7249, _e453) + 0.5f) / f32(_e936)) * 2f)) * _e7527);
let _e7530 = global_1.member.member_3;
let _e7538 = global_1.member.member_4;
let _e7545 = ((_e7530.member * _e7520) + (_e7538.member * _e7528));
let _e7546 = ((_e7530.member_1 * _e7520) + (_e7538.member_1 * _e7528));
let _e7547 = ((_e7530.member_2 * _e7520) + (_e7538.member_2 * _e7528));
let _e7550 = global_1.member.member_2.member_3;
let _e7551 = (_e7550 != 0u);
let _e7553 = global_1.member.member_5;
let _e7560 = select((_e7553.member + _e7545), _e7553.member, _e7551);
let _e7561 = select((_e7553.member_1 + _e7546), _e7553.member_1, _e7551);
let _e7562 = select((_e7553.member_2 + _e7547), _e7553.member_2, _e7551);
let _e7564 = global_1.member.member_6;
let _e7571 = select(_e7564.member, (_e7564.member + _e7545), _e7551);
let _e7572 = select(_e7564.member_1, (_e7564.member_1 + _e7546), _e7551);
let _e7573 = select(_e7564.member_2, (_e7564.member_2 + _e7547), _e7551);
let _e7578 = (((_e7560 * _e7560) + (_e7561 * _e7561)) + (_e7562 * _e7562));
let _e7581 = sqrt(select(0f, _e7578, (_e7578 > 0f)));
let _e7582 = (1f / _e7581);
let _e7583 = (_e7560 * _e7582);
let _e7584 = (_e7561 * _e7582);
let _e7585 = (_e7562 * _e7582);
let _e7586 = (_e575 - _e7571);
let _e7587 = (_e587 - _e7572);
let _e7588 = (_e600 - _e7573);
let _e7593 = (((_e7586 * _e7583) + (_e7587 * _e7584)) + (_e7588 * _e7585));
let _e7598 = (((_e7586 * _e613) + (_e7587 * _e626)) + (_e7588 * _e639));
let _e7603 = (((_e7583 * _e613) + (_e7584 * _e626)) + (_e7585 * _e639));
let _e7606 = ((_e7584 * _e639) - (_e7585 * _e626));
let _e7609 = ((_e7585 * _e613) - (_e7583 * _e639));
let _e7612 = ((_e7583 * _e626) - (_e7584 * _e613));
let _e7617 = (((_e7606 * _e7606) + (_e7609 * _e7609)) + (_e7612 * _e7612));
let _e7620 = (1f / select(1e-9f, _e7617, (_e7617 > 1e-9f)));
let _e7623 = ((_e7593 - (_e7603 * _e7598)) * _e7620);
let _e7626 = (((_e7603 * _e7593) - _e7598) * _e7620);
let _e7632 = -(_e7603);
let _e7635 = global_1.member.member_13.member_2;
let _e7636 = (_e7635 * _e7635);
let _e7640 = ((1f + _e7636) - ((2f * _e7635) * _e7632));
let _e7642 = select(1e-9f, _e7640, (_e7640 > 1e-9f));
let _e7654 = global_1.member.member_13.member_3;
if (_e7654 == 2u) {
let _e7659 = (0.5f - (0.5f * _e7632));
let _e7661 = select(0f, _e7659, (_e7659 > 0f));
let _e7665 = (sqrt(select(0f, _e7661, (_e7661 > 0f))) * 255f);
let _e7666 = (255f - 1f);
let _e7668 = select(0f, _e7665, (_e7665 > 0f));
let _e7670 = select(_e7666, _e7668, (_e7668 < _e7666));
let _e7677 = select(0i, select(select(i32(_e7670), i32(-2147483648), (_e7670 < -2147483600f)), 2147483647i, (_e7670 > 2147483500f)), (_e7670 == _e7670));
let _e7681 = (_e7677 - select(0i, 1i, (_e7670 < f32(_e7677))));
let _e7684 = global_1.member.member_13.member_11;
let _e7685 = bitcast<i32>(_e7684);
let _e7686 = (_e7685 + _e7681);
let _e7688 = (bitcast<i32>(_e265) - 1i);
let _e7690 = select(_e7688, _e7686, (_e7686 < _e7688));
let _e7695 = global_2.member[bitcast<u32>(select(0i, _e7690, (_e7690 > 0i)))];
let _e7697 = (_e7685 + (_e7681 + 1i));
let _e7699 = select(_e7688, _e7697, (_e7697 < _e7688));
let _e7704 = global_2.member[bitcast<u32>(select(0i, _e7699, (_e7699 > 0i)))];
phi_21246_ = (_e7695 + ((_e7704 - _e7695) * (_e7665 - f32(_e7681))));
} else {
phi_21246_ = select(((1f - _e7636) / (_e7642 * sqrt(select(0f, _e7642, (_e7642 > 0f))))), (0.75f * (1f + (_e7632 * _e7632))), (_e7654 == 1u));
}
let _e7711 = phi_21246_;
let _e7717 = global_1.member.member_12.member_11;
let _e7720 = global_1.member.member_12.member_4;
let _e7723 = global_1.member.member_12.member_12;
let _e7729 = global_1.member.member.member;
let _e7731 = (_e7626 / _e691);
local_147 = bitcast<i32>((_e7717 + (_e7720 * _e7723)));
local_148 = _e281;
local_149 = bitcast<i32>(_e7729);
let _e7734 = global_1.member.member_13.member_6;
let _e7735 = f32(_e7734);
let _e7737 = select(0f, _e7731, (_e7731 > 0f));
let _e7740 = (select(1f, _e7737, (_e7737 < 1f)) * _e7735);
let _e7741 = (_e7735 - 1f);
let _e7743 = select(0f, _e7741, (_e7741 > 0f));
let _e7745 = select(0f, _e7740, (_e7740 > 0f));
let _e7747 = select(_e7743, _e7745, (_e7745 < _e7743));
let _e7754 = select(0i, select(select(i32(_e7747), i32(-2147483648), (_e7747 < -2147483600f)), 2147483647i, (_e7747 > 2147483500f)), (_e7747 == _e7747));
let _e7758 = (_e7754 - select(0i, 1i, (_e7747 < f32(_e7754))));
if (_e7758 > 0i) {
let _e7761 = local_147;
let _e7762 = local_149;
let _e7765 = local_148;
let _e7766 = ((_e7761 + ((_e7758 - 1i) * _e7762)) + _e7765);
let _e7768 = (bitcast<i32>(_e268) - 1i);
let _e7770 = select(_e7768, _e7766, (_e7766 < _e7768));
let _e7775 = global_7.member[bitcast<u32>(select(0i, _e7770, (_e7770 > 0i)))];
phi_21352_ = _e7775;
} else {
phi_21352_ = 0f;
}
let _e7777 = phi_21352_;
let _e7778 = local_147;
let _e7779 = local_149;
let _e7782 = local_148;
let _e7783 = ((_e7778 + (_e7758 * _e7779)) + _e7782);
let _e7785 = (bitcast<i32>(_e268) - 1i);
let _e7787 = select(_e7785, _e7783, (_e7783 < _e7785));
let _e7792 = global_7.member[bitcast<u32>(select(0i, _e7787, (_e7787 > 0i)))];
let _e7799 = (_e7509 - _e7498);
let _e7802 = ((_e7623 - _e7498) / select(1e-9f, _e7799, (_e7799 > 1e-9f)));
local_144 = 0i;
local_145 = _e7510;
local_146 = _e7484;
let _e7804 = select(0f, _e7802, (_e7802 > 0f));
let _e7807 = (select(1f, _e7804, (_e7804 < 1f)) * _e7735);
let _e7809 = select(0f, _e7807, (_e7807 > 0f));
let _e7811 = select(_e7743, _e7809, (_e7809 < _e7743));
let _e7818 = select(0i, select(select(i32(_e7811), i32(-2147483648), (_e7811 < -2147483600f)), 2147483647i, (_e7811 > 2147483500f)), (_e7811 == _e7811));
let _e7822 = (_e7818 - select(0i, 1i, (_e7811 < f32(_e7818))));
if (_e7822 > 0i) {
let _e7825 = local_144;
let _e7826 = local_146;
let _e7829 = local_145;
let _e7830 = ((_e7825 + ((_e7822 - 1i) * _e7826)) + _e7829);
let _e7832 = select(_e7785, _e7830, (_e7830 < _e7785));
let _e7837 = global_7.member[bitcast<u32>(select(0i, _e7832, (_e7832 > 0i)))];
phi_21479_ = _e7837;
} else {
phi_21479_ = 0f;
}
let _e7839 = phi_21479_;
let _e7840 = local_144;
let _e7841 = local_146;
let _e7844 = local_145;
let _e7845 = ((_e7840 + (_e7822 * _e7841)) + _e7844);
let _e7847 = select(_e7785, _e7845, (_e7845 < _e7785));
let _e7852 = global_7.member[bitcast<u32>(select(0i, _e7847, (_e7847 > 0i)))];
let _e7858 = ((_e7777 + ((_e7792 - _e7777) * (_e7740 - f32(_e7758)))) + (_e7839 + ((_e7852 - _e7839) * (_e7807 - f32(_e7822)))));
let _e7867 = global_1.member.member_13.member_7;
let _e7868 = bitcast<i32>(_e7867);
let _e7871 = global_1.member.member_13.member_8;
let _e7872 = bitcast<i32>(_e7871);
let _e7875 = global_1.member.member_13.member_9;
let _e7876 = bitcast<i32>(_e7875);
let _e7879 = global_1.member.member_13.member_4;
let _e7885 = global_1.member.member_13.member_5;
let _e7889 = f32(_e7868);
let _e7894 = (((((_e7571 + (_e7583 * _e7623)) - _e7879.member) / (_e7885.member - _e7879.member)) * _e7889) - 0.5f);
let _e7895 = (_e7889 - 1f);
let _e7897 = select(0f, _e7894, (_e7894 > 0f));
let _e7899 = select(_e7895, _e7897, (_e7897 < _e7895));
let _e7900 = f32(_e7872);
let _e7905 = (((((_e7572 + (_e7584 * _e7623)) - _e7879.member_1) / (_e7885.member_1 - _e7879.member_1)) * _e7900) - 0.5f);
let _e7906 = (_e7900 - 1f);
let _e7908 = select(0f, _e7905, (_e7905 > 0f));
let _e7910 = select(_e7906, _e7908, (_e7908 < _e7906));
let _e7911 = f32(_e7876);
let _e7916 = (((((_e7573 + (_e7585 * _e7623)) - _e7879.member_2) / (_e7885.member_2 - _e7879.member_2)) * _e7911) - 0.5f);
let _e7917 = (_e7911 - 1f);
let _e7919 = select(0f, _e7916, (_e7916 > 0f));
let _e7921 = select(_e7917, _e7919, (_e7919 < _e7917));
let _e7923 = select(0f, _e7899, (_e7899 > 0f));
let _e7925 = select(1e6f, _e7923, (_e7923 < 1e6f));
let _e7932 = select(0i, select(select(i32(_e7925), i32(-2147483648), (_e7925 < -2147483600f)), 2147483647i, (_e7925 > 2147483500f)), (_e7925 == _e7925));
let _e7936 = (_e7932 - select(0i, 1i, (_e7925 < f32(_e7932))));
let _e7938 = select(0f, _e7910, (_e7910 > 0f));
let _e7940 = select(1e6f, _e7938, (_e7938 < 1e6f));
let _e7947 = select(0i, select(select(i32(_e7940), i32(-2147483648), (_e7940 < -2147483600f)), 2147483647i, (_e7940 > 2147483500f)), (_e7940 == _e7940));
let _e7951 = (_e7947 - select(0i, 1i, (_e7940 < f32(_e7947))));
let _e7953 = select(0f, _e7921, (_e7921 > 0f));
let _e7955 = select(1e6f, _e7953, (_e7953 < 1e6f));
let _e7962 = select(0i, select(select(i32(_e7955), i32(-2147483648), (_e7955 < -2147483600f)), 2147483647i, (_e7955 > 2147483500f)), (_e7955 == _e7955));
let _e7966 = (_e7962 - select(0i, 1i, (_e7955 < f32(_e7962))));
let _e7970 = (_e7910 - f32(_e7951));
let _e7972 = (_e7921 - f32(_e7966));
local_142 = (_e7899 - f32(_e7936));
let _e7973 = (_e7936 + 1i);
let _e7975 = select(_e7973, 0i, (_e7973 < 0i));
if (_e7975 >= _e7868) {
phi_21627_ = (_e7868 - 1i);
} else {
phi_21627_ = _e7975;
}
let _e7979 = phi_21627_;
local_143 = (_e7979 - _e7936);
let _e7981 = (_e7951 + 1i);
let _e7983 = select(_e7981, 0i, (_e7981 < 0i));
if (_e7983 >= _e7872) {
phi_21640_ = (_e7872 - 1i);
} else {
phi_21640_ = _e7983;
}
let _e7987 = phi_21640_;
let _e7989 = ((_e7987 - _e7951) * _e7868);
let _e7990 = (_e7966 + 1i);
let _e7992 = select(_e7990, 0i, (_e7990 < 0i));
if (_e7992 >= _e7876) {
phi_21654_ = (_e7876 - 1i);
} else {
phi_21654_ = _e7992;
}
let _e7996 = phi_21654_;
let _e8002 = global_1.member.member_13.member_10;
let _e8008 = ((bitcast<i32>(_e8002) + (((_e7966 * _e7872) + _e7951) * _e7868)) + _e7936);
let _e8010 = (bitcast<i32>(_e265) - 1i);
let _e8012 = select(_e8010, _e8008, (_e8008 < _e8010));
let _e8017 = global_2.member[bitcast<u32>(select(0i, _e8012, (_e8012 > 0i)))];
let _e8018 = local_142;
let _e8021 = local_143;
let _e8022 = (_e8008 + _e8021);
let _e8024 = select(_e8010, _e8022, (_e8022 < _e8010));
let _e8029 = global_2.member[bitcast<u32>(select(0i, _e8024, (_e8024 > 0i)))];
let _e8030 = local_142;
let _e8033 = (1f - _e7970);
let _e8035 = (_e8008 + _e7989);
let _e8037 = select(_e8010, _e8035, (_e8035 < _e8010));
let _e8042 = global_2.member[bitcast<u32>(select(0i, _e8037, (_e8037 > 0i)))];
let _e8043 = local_142;
let _e8046 = local_143;
let _e8047 = (_e8035 + _e8046);
let _e8049 = select(_e8010, _e8047, (_e8047 < _e8010));
let _e8054 = global_2.member[bitcast<u32>(select(0i, _e8049, (_e8049 > 0i)))];
let _e8055 = local_142;
let _e8060 = (_e8008 + (((_e7996 - _e7966) * _e7868) * _e7872));
let _e8062 = select(_e8010, _e8060, (_e8060 < _e8010));
let _e8067 = global_2.member[bitcast<u32>(select(0i, _e8062, (_e8062 > 0i)))];
let _e8068 = local_142;
let _e8071 = local_143;
let _e8072 = (_e8060 + _e8071);
let _e8074 = select(_e8010, _e8072, (_e8072 < _e8010));
let _e8079 = global_2.member[bitcast<u32>(select(0i, _e8074, (_e8074 > 0i)))];
let _e8080 = local_142;
let _e8084 = (_e8060 + _e7989);
let _e8086 = select(_e8010, _e8084, (_e8084 < _e8010));
let _e8091 = global_2.member[bitcast<u32>(select(0i, _e8086, (_e8086 > 0i)))];
let _e8092 = local_142;
let _e8095 = local_143;
let _e8096 = (_e8084 + _e8095);
let _e8098 = select(_e8010, _e8096, (_e8096 < _e8010));
let _e8103 = global_2.member[bitcast<u32>(select(0i, _e8098, (_e8098 > 0i)))];
let _e8104 = local_142;
let _e8113 = ((_e7581 * (_e7711 * (0.25f / 3.1415927f))) * ((((((_e8017 * (1f - _e8018)) + (_e8029 * _e8030)) * _e8033) + (((_e8042 * (1f - _e8043)) + (_e8054 * _e8055)) * _e7970)) * (1f - _e7972)) + (((((_e8067 * (1f - _e8068)) + (_e8079 * _e8080)) * _e8033) + (((_e8091 * (1f - _e8092)) + (_e8103 * _e8104)) * _e7970)) * _e7972)));
let _e8116 = global_1.member.member_13.member_1;
let _e8125 = global_1.member.member_13.member;
let _e8130 = -((_e8125.member * _e7858));
let _e8132 = select(-87f, _e8130, (_e8130 > -87f));
let _e8134 = select(88f, _e8132, (_e8132 < 88f));
let _e8136 = ((_e8134 * 1.442695f) + 0.5f);
let _e8138 = select(-127f, _e8136, (_e8136 > -127f));
let _e8140 = select(128f, _e8138, (_e8138 < 128f));
let _e8147 = select(0i, select(select(i32(_e8140), i32(-2147483648), (_e8140 < -2147483600f)), 2147483647i, (_e8140 > 2147483500f)), (_e8140 == _e8140));
let _e8151 = (_e8147 - select(0i, 1i, (_e8140 < f32(_e8147))));
let _e8152 = f32(_e8151);
let _e8156 = ((_e8134 - (_e8152 * 0.6933594f)) - (_e8152 * -2.1219444e-4f));
let _e8178 = -((_e8125.member_1 * _e7858));
let _e8180 = select(-87f, _e8178, (_e8178 > -87f));
let _e8182 = select(88f, _e8180, (_e8180 < 88f));
let _e8184 = ((_e8182 * 1.442695f) + 0.5f);
let _e8186 = select(-127f, _e8184, (_e8184 > -127f));
let _e8188 = select(128f, _e8186, (_e8186 < 128f));
let _e8195 = select(0i, select(select(i32(_e8188), i32(-2147483648), (_e8188 < -2147483600f)), 2147483647i, (_e8188 > 2147483500f)), (_e8188 == _e8188));
let _e8199 = (_e8195 - select(0i, 1i, (_e8188 < f32(_e8195))));
let _e8200 = f32(_e8199);
let _e8204 = ((_e8182 - (_e8200 * 0.6933594f)) - (_e8200 * -2.1219444e-4f));
let _e8226 = -((_e8125.member_2 * _e7858));
let _e8228 = select(-87f, _e8226, (_e8226 > -87f));
let _e8230 = select(88f, _e8228, (_e8228 < 88f));
let _e8232 = ((_e8230 * 1.442695f) + 0.5f);
let _e8234 = select(-127f, _e8232, (_e8232 > -127f));
let _e8236 = select(128f, _e8234, (_e8234 < 128f));
let _e8243 = select(0i, select(select(i32(_e8236), i32(-2147483648), (_e8236 < -2147483600f)), 2147483647i, (_e8236 > 2147483500f)), (_e8236 == _e8236));
let _e8247 = (_e8243 - select(0i, 1i, (_e8236 < f32(_e8243))));
let _e8248 = f32(_e8247);
let _e8252 = ((_e8230 - (_e8248 * 0.6933594f)) - (_e8248 * -2.1219444e-4f));
let _e8279 = select(0f, _e7623, (((_e7626 >= 0f) && (_e7626 < _e691)) && (_e7623 > 0f)));
let _e8282 = ((_e8279 > 0f) && (_e8279 < _e7441));
if _e453 {
phi_22110_ = type_23(_e7341, _e7245);
} else {
phi_22110_ = type_23(_e7245, _e7341);
}
let _e8306 = phi_22110_;
let _e8309 = (_e7342 && _e8282);
let _e8312 = global_1.member.member_18.member;
let _e8313 = (((select(_e7367, (1f - _e7367), (_e7352 >= 0f)) - select(_e7386, (1f - _e7386), (_e7371 >= 0f))) * (1f / _e7349)) * _e8312);
let _e8317 = select(0f, ((((_e652 * _e8116.member) * ((1f + (_e8156 * (1f + (_e8156 * (0.5f + (_e8156 * (0.16666667f + (_e8156 * (0.041666668f + (_e8156 * (0.008333334f + (_e8156 * (0.001388889f + (_e8156 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8151 + 127i)) << bitcast<u32>(23i))))) * _e8113) * _e8313), _e8309);
let _e8318 = select(0f, ((((_e665 * _e8116.member_1) * ((1f + (_e8204 * (1f + (_e8204 * (0.5f + (_e8204 * (0.16666667f + (_e8204 * (0.041666668f + (_e8204 * (0.008333334f + (_e8204 * (0.001388889f + (_e8204 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8199 + 127i)) << bitcast<u32>(23i))))) * _e8113) * _e8313), _e8309);
let _e8319 = select(0f, ((((_e678 * _e8116.member_2) * ((1f + (_e8252 * (1f + (_e8252 * (0.5f + (_e8252 * (0.16666667f + (_e8252 * (0.041666668f + (_e8252 * (0.008333334f + (_e8252 * (0.001388889f + (_e8252 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8247 + 127i)) << bitcast<u32>(23i))))) * _e8113) * _e8313), _e8309);
let _e8323 = (bitcast<f32>((bitcast<u32>(_e8317) & 2147483647u)) >= 1073741800f);
let _e8324 = (1f / 1048576f);
let _e8327 = ((_e8317 * select(1f, _e8324, _e8323)) + 0.5f);
let _e8329 = select(-1073741800f, _e8327, (_e8327 > -1073741800f));
let _e8331 = select(1073741800f, _e8329, (_e8329 < 1073741800f));
let _e8338 = select(0i, select(select(i32(_e8331), i32(-2147483648), (_e8331 < -2147483600f)), 2147483647i, (_e8331 > 2147483500f)), (_e8331 == _e8331));
let _e8342 = (_e8338 - select(0i, 1i, (_e8331 < f32(_e8338))));
let _e8343 = select(0i, 20i, _e8323);
let _e8347 = (bitcast<u32>(_e8342) << bitcast<u32>((_e8343 & 31i)));
let _e8354 = bitcast<u32>(((_e8342 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8343) & 31i))));
let _e8358 = (bitcast<f32>((bitcast<u32>(_e8318) & 2147483647u)) >= 1073741800f);
let _e8361 = ((_e8318 * select(1f, _e8324, _e8358)) + 0.5f);
let _e8363 = select(-1073741800f, _e8361, (_e8361 > -1073741800f));
let _e8365 = select(1073741800f, _e8363, (_e8363 < 1073741800f));
let _e8372 = select(0i, select(select(i32(_e8365), i32(-2147483648), (_e8365 < -2147483600f)), 2147483647i, (_e8365 > 2147483500f)), (_e8365 == _e8365));
let _e8376 = (_e8372 - select(0i, 1i, (_e8365 < f32(_e8372))));
let _e8377 = select(0i, 20i, _e8358);
let _e8381 = (bitcast<u32>(_e8376) << bitcast<u32>((_e8377 & 31i)));
let _e8388 = bitcast<u32>(((_e8376 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8377) & 31i))));
let _e8392 = (bitcast<f32>((bitcast<u32>(_e8319) & 2147483647u)) >= 1073741800f);
let _e8395 = ((_e8319 * select(1f, _e8324, _e8392)) + 0.5f);
let _e8397 = select(-1073741800f, _e8395, (_e8395 > -1073741800f));
let _e8399 = select(1073741800f, _e8397, (_e8397 < 1073741800f));
let _e8406 = select(0i, select(select(i32(_e8399), i32(-2147483648), (_e8399 < -2147483600f)), 2147483647i, (_e8399 > 2147483500f)), (_e8399 == _e8399));
let _e8410 = (_e8406 - select(0i, 1i, (_e8399 < f32(_e8406))));
let _e8411 = select(0i, 20i, _e8392);
let _e8415 = (bitcast<u32>(_e8410) << bitcast<u32>((_e8411 & 31i)));
let _e8422 = bitcast<u32>(((_e8410 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8411) & 31i))));
let _e8427 = global_1.member.member_18.member_2;
let _e8430 = global_1.member.member_18.member_3;
let _e8433 = global_1.member.member_18.member_4;
let _e8436 = global_1.member.member_18.member_5;
if _e986 {
phi_22309_ = 0u;
} else {
if (_e766 == 1u) {
phi_22308_ = _e8427;
} else {
if (_e766 == 2u) {
phi_22307_ = _e8430;
} else {
phi_22307_ = select(_e8436, _e8433, (_e766 == 3u));
}
let _e8442 = phi_22307_;
phi_22308_ = _e8442;
}
let _e8444 = phi_22308_;
phi_22309_ = _e8444;
}
let _e8446 = phi_22309_;
let _e8454 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e8446) + (_e8306.member_1 * _e7214)) + _e8306.member) * 6i)));
if ((_e8347 | _e8354) == 0u) {
} else {
let _e8457 = bitcast<u32>(_e8454);
if (_e8457 < _e270) {
let _e8461 = atomicAdd((&global_8.member[_e8457]), _e8347);
phi_22343_ = _e8461;
} else {
phi_22343_ = 0u;
}
let _e8463 = phi_22343_;
let _e8467 = (_e8354 + select(0u, 1u, ((_e8463 + _e8347) < _e8347)));
if (_e8467 == 0u) {
} else {
let _e8469 = (_e8457 + 1u);
if (_e8469 < _e270) {
let _e8473 = atomicAdd((&global_8.member[_e8469]), _e8467);
}
}
}
if ((_e8381 | _e8388) == 0u) {
} else {
let _e8477 = bitcast<u32>((_e8454 + 2i));
if (_e8477 < _e270) {
let _e8481 = atomicAdd((&global_8.member[_e8477]), _e8381);
phi_22373_ = _e8481;
} else {
phi_22373_ = 0u;
}
let _e8483 = phi_22373_;
let _e8487 = (_e8388 + select(0u, 1u, ((_e8483 + _e8381) < _e8381)));
if (_e8487 == 0u) {
} else {
let _e8489 = (_e8477 + 1u);
if (_e8489 < _e270) {
let _e8493 = atomicAdd((&global_8.member[_e8489]), _e8487);
}
}
}
if ((_e8415 | _e8422) == 0u) {
} else {
let _e8497 = bitcast<u32>((_e8454 + 4i));
if (_e8497 < _e270) {
let _e8501 = atomicAdd((&global_8.member[_e8497]), _e8415);
phi_22403_ = _e8501;
} else {
phi_22403_ = 0u;
}
let _e8503 = phi_22403_;
let _e8507 = (_e8422 + select(0u, 1u, ((_e8503 + _e8415) < _e8415)));
if (_e8507 == 0u) {
} else {
let _e8509 = (_e8497 + 1u);
if (_e8509 < _e270) {
let _e8513 = atomicAdd((&global_8.member[_e8509]), _e8507);
}
}
}
let _e8514 = bitcast<i32>(bitcast<u32>(select(-1i, _e7341, (_e7342 && (!(((_e8282 && !(((((_e7245 * _e7237) == _e298) && (_e847 != _e766)) || ((((_e7245 + 1i) * _e7237) == _e692) && (_e927 != _e766))))) && ((_e8279 * (1f + (0.02f * _e7238))) < _e7462))) && (_e8279 <= _e7451))))));
if (_e8514 >= 0i) {
phi_22440_ = type_23(select(_e7336.member, _e8514, (_e8514 < _e7336.member)), select(_e7336.member_1, _e8514, (_e8514 > _e7336.member_1)));
} else {
phi_22440_ = _e7336;
}
let _e8524 = phi_22440_;
phi_20503_ = _e8524;
phi_20506_ = (_e7338 + 1i);
} else {
phi_20503_ = type_23();
phi_20506_ = i32();
}
let _e8527 = phi_20503_;
let _e8529 = phi_20506_;
continue;
continuing {
phi_20502_ = _e8527;
phi_20505_ = _e8529;
break if !(_e7342);
}
}
let _e25965 = local_241;
phi_20349_ = _e25965;
phi_20352_ = (_e7234 + 1i);
} else {
phi_20349_ = type_23();
phi_20352_ = i32();
}
let _e8533 = phi_20349_;
let _e8535 = phi_20352_;
continue;
continuing {
phi_20348_ = _e8533;
phi_20351_ = _e8535;
break if !(_e7235);
}
}
let _e8538 = local_231;
let _e8541 = local_232;
if (_e8538.member <= _e8541.member_1) {
let _e8546 = ((_e8541.member_1 + 1i) << bitcast<u32>(_e7203));
if (_e8546 <= _e985) {
phi_22457_ = (_e8546 - 1i);
} else {
phi_22457_ = _e985;
}
let _e8550 = phi_22457_;
let _e8552 = (_e8538.member << bitcast<u32>(_e7203));
let _e8554 = select(_e847, 0u, (_e847 == _e766));
let _e8558 = select(_e927, 0u, ((_e927 == _e766) || (_e927 == _e847)));
let _e8566 = ((select(0u, 1u, (_e766 > 0u)) + select(0u, 1u, (_e8554 > 0u))) + select(0u, 1u, (_e8558 > 0u)));
if (_e8566 == 0u) {
phi_22492_ = 0i;
loop {
let _e8569 = phi_22492_;
let _e8570 = (_e8569 < 16i);
if _e8570 {
let _e8572 = (_e980 + (_e8569 & 15i));
let _e8576 = (((f32(_e8572) + 0.5f) * 1f) - 0.5f);
let _e8580 = (-(((_e416 * _e8576) + _e442)) / _e429);
let _e8587 = bitcast<f32>((bitcast<u32>(((_e466 * _e8576) + ((_e479 * _e8580) + _e492))) & 2147483647u));
let _e8594 = bitcast<f32>((bitcast<u32>(((_e505 * _e8576) + ((_e518 * _e8580) + _e531))) & 2147483647u));
let _e8598 = (((0.5f * (_e8587 + _e8594)) / _e534) + _e717);
let _e8599 = (1f / 1f);
let _e8607 = ((((_e8580 + _e8598) + 0.5f) * _e8599) - 0.5f);
let _e8608 = f32(_e8552);
let _e8609 = f32(_e8550);
let _e8610 = (_e8608 - 1f);
let _e8612 = select(_e8610, _e8607, (_e8607 > _e8610));
let _e8614 = select(_e8609, _e8612, (_e8612 < _e8609));
let _e8621 = select(0i, select(select(i32(_e8614), i32(-2147483648), (_e8614 < -2147483600f)), 2147483647i, (_e8614 > 2147483500f)), (_e8614 == _e8614));
let _e8626 = (((((_e8580 - _e8598) + 0.5f) * _e8599) - 0.5f) + 1f);
let _e8627 = (_e8609 + 1f);
let _e8629 = select(_e8608, _e8626, (_e8626 > _e8608));
let _e8631 = select(_e8627, _e8629, (_e8629 < _e8627));
let _e8638 = select(0i, select(select(i32(_e8631), i32(-2147483648), (_e8631 < -2147483600f)), 2147483647i, (_e8631 > 2147483500f)), (_e8631 == _e8631));
let _e8649 = ((1e-4f * 1f) * _e534);
let _e8651 = select(_e8594, _e8587, (_e8587 > _e8594));
let _e8653 = select(_e8649, _e8651, (_e8651 > _e8649));
let _e8655 = select(_e8594, _e8587, (_e8587 < _e8594));
let _e8657 = select(_e8649, _e8655, (_e8655 > _e8649));
let _e8659 = (0.5f * (_e8653 + _e8657));
let _e8660 = (0.5f / _e8657);
let _e8661 = (1f / _e8653);
phi_22646_ = 0i;
loop {
let _e8663 = phi_22646_;
let _e8665 = (((_e8638 - select(0i, 1i, (_e8631 < f32(_e8638)))) + (_e8569 >> bitcast<u32>(4u))) + bitcast<i32>(_e8663));
let _e8666 = (_e8665 <= select(-1i, (_e8621 - select(0i, 1i, (_e8614 < f32(_e8621)))), (_e8572 <= _e984)));
if _e8666 {
let _e8672 = (((((f32(_e8665) + 0.5f) * 1f) - 0.5f) - _e8580) * _e534);
let _e8673 = (_e534 * 1f);
let _e8675 = (0.5f * _e8673);
let _e8676 = (_e8672 + _e8675);
let _e8677 = -(_e8676);
let _e8680 = (_e8659 - select(_e8677, _e8676, (_e8676 > _e8677)));
let _e8682 = select(0f, _e8680, (_e8680 > 0f));
let _e8684 = select(_e8657, _e8682, (_e8682 < _e8657));
let _e8687 = (_e8680 - _e8657);
let _e8691 = (((_e8684 * (_e8684 * _e8660)) + select(0f, _e8687, (_e8687 > 0f))) * _e8661);
let _e8695 = (_e8672 - _e8675);
let _e8696 = -(_e8695);
let _e8699 = (_e8659 - select(_e8696, _e8695, (_e8695 > _e8696)));
let _e8701 = select(0f, _e8699, (_e8699 > 0f));
let _e8703 = select(_e8657, _e8701, (_e8701 < _e8657));
let _e8706 = (_e8699 - _e8657);
let _e8710 = (((_e8703 * (_e8703 * _e8660)) + select(0f, _e8706, (_e8706 > 0f))) * _e8661);
if _e453 {
phi_22751_ = type_23(_e8665, _e8572);
} else {
phi_22751_ = type_23(_e8572, _e8665);
}
let _e8719 = phi_22751_;
let _e8723 = bitcast<i32>((_e931 * _e934));
local_140 = _e8723;
local_141 = ((_e8719.member_1 * _e935) + _e8719.member);
let _e8726 = local_140;
let _e8727 = local_141;
let _e8728 = (_e8726 + _e8727);
let _e8730 = (bitcast<i32>(_e259) - 1i);
let _e8732 = select(_e8730, _e8728, (_e8728 < _e8730));
let _e8737 = global_5.member[bitcast<u32>(select(0i, _e8732, (_e8732 > 0i)))];
let _e8738 = local_140;
let _e8740 = local_141;
let _e8741 = ((2i * _e8738) + _e8740);
let _e8743 = select(_e8730, _e8741, (_e8741 < _e8730));
let _e8748 = global_5.member[bitcast<u32>(select(0i, _e8743, (_e8743 > 0i)))];
let _e8749 = local_141;
let _e8751 = select(_e8730, _e8749, (_e8749 < _e8730));
let _e8756 = global_5.member[bitcast<u32>(select(0i, _e8751, (_e8751 > 0i)))];
let _e8757 = local_141;
let _e8768 = global_1.member.member_2.member;
let _e8769 = (((((f32(_e8719.member) + 0.5f) / f32(_e935)) * 2f) - 1f) * _e8768);
let _e8776 = global_1.member.member_2.member_1;
let _e8777 = ((1f - (((f32(_e8719.member_1) + 0.5f) / f32(_e936)) * 2f)) * _e8776);
let _e8779 = global_1.member.member_3;
let _e8787 = global_1.member.member_4;
let _e8794 = ((_e8779.member * _e8769) + (_e8787.member * _e8777));
let _e8795 = ((_e8779.member_1 * _e8769) + (_e8787.member_1 * _e8777));
let _e8796 = ((_e8779.member_2 * _e8769) + (_e8787.member_2 * _e8777));
let _e8799 = global_1.member.member_2.member_3;
let _e8800 = (_e8799 != 0u);
let _e8802 = global_1.member.member_5;
let _e8809 = select((_e8802.member + _e8794), _e8802.member, _e8800);
let _e8810 = select((_e8802.member_1 + _e8795), _e8802.member_1, _e8800);
let _e8811 = select((_e8802.member_2 + _e8796), _e8802.member_2, _e8800);
let _e8813 = global_1.member.member_6;
let _e8820 = select(_e8813.member, (_e8813.member + _e8794), _e8800);
let _e8821 = select(_e8813.member_1, (_e8813.member_1 + _e8795), _e8800);
let _e8822 = select(_e8813.member_2, (_e8813.member_2 + _e8796), _e8800);
let _e8827 = (((_e8809 * _e8809) + (_e8810 * _e8810)) + (_e8811 * _e8811));
let _e8830 = sqrt(select(0f, _e8827, (_e8827 > 0f)));
let _e8831 = (1f / _e8830);
let _e8832 = (_e8809 * _e8831);
let _e8833 = (_e8810 * _e8831);
let _e8834 = (_e8811 * _e8831);
let _e8835 = (_e575 - _e8820);
let _e8836 = (_e587 - _e8821);
let _e8837 = (_e600 - _e8822);
let _e8842 = (((_e8835 * _e8832) + (_e8836 * _e8833)) + (_e8837 * _e8834));
let _e8847 = (((_e8835 * _e613) + (_e8836 * _e626)) + (_e8837 * _e639));
let _e8852 = (((_e8832 * _e613) + (_e8833 * _e626)) + (_e8834 * _e639));
let _e8855 = ((_e8833 * _e639) - (_e8834 * _e626));
let _e8858 = ((_e8834 * _e613) - (_e8832 * _e639));
let _e8861 = ((_e8832 * _e626) - (_e8833 * _e613));
let _e8866 = (((_e8855 * _e8855) + (_e8858 * _e8858)) + (_e8861 * _e8861));
let _e8869 = (1f / select(1e-9f, _e8866, (_e8866 > 1e-9f)));
let _e8872 = ((_e8842 - (_e8852 * _e8847)) * _e8869);
let _e8875 = (((_e8852 * _e8842) - _e8847) * _e8869);
let _e8881 = -(_e8852);
let _e8884 = global_1.member.member_13.member_2;
let _e8885 = (_e8884 * _e8884);
let _e8889 = ((1f + _e8885) - ((2f * _e8884) * _e8881));
let _e8891 = select(1e-9f, _e8889, (_e8889 > 1e-9f));
let _e8903 = global_1.member.member_13.member_3;
if (_e8903 == 2u) {
let _e8908 = (0.5f - (0.5f * _e8881));
let _e8910 = select(0f, _e8908, (_e8908 > 0f));
let _e8914 = (sqrt(select(0f, _e8910, (_e8910 > 0f))) * 255f);
let _e8915 = (255f - 1f);
let _e8917 = select(0f, _e8914, (_e8914 > 0f));
let _e8919 = select(_e8915, _e8917, (_e8917 < _e8915));
let _e8926 = select(0i, select(select(i32(_e8919), i32(-2147483648), (_e8919 < -2147483600f)), 2147483647i, (_e8919 > 2147483500f)), (_e8919 == _e8919));
let _e8930 = (_e8926 - select(0i, 1i, (_e8919 < f32(_e8926))));
let _e8933 = global_1.member.member_13.member_11;
let _e8934 = bitcast<i32>(_e8933);
let _e8935 = (_e8934 + _e8930);
let _e8937 = (bitcast<i32>(_e265) - 1i);
let _e8939 = select(_e8937, _e8935, (_e8935 < _e8937));
let _e8944 = global_2.member[bitcast<u32>(select(0i, _e8939, (_e8939 > 0i)))];
let _e8946 = (_e8934 + (_e8930 + 1i));
let _e8948 = select(_e8937, _e8946, (_e8946 < _e8937));
let _e8953 = global_2.member[bitcast<u32>(select(0i, _e8948, (_e8948 > 0i)))];
phi_23178_ = (_e8944 + ((_e8953 - _e8944) * (_e8914 - f32(_e8930))));
} else {
phi_23178_ = select(((1f - _e8885) / (_e8891 * sqrt(select(0f, _e8891, (_e8891 > 0f))))), (0.75f * (1f + (_e8881 * _e8881))), (_e8903 == 1u));
}
let _e8960 = phi_23178_;
let _e8966 = global_1.member.member_12.member_11;
let _e8969 = global_1.member.member_12.member_4;
let _e8972 = global_1.member.member_12.member_12;
let _e8978 = global_1.member.member.member;
let _e8980 = (_e8875 / _e691);
local_137 = bitcast<i32>((_e8966 + (_e8969 * _e8972)));
local_138 = _e281;
local_139 = bitcast<i32>(_e8978);
let _e8983 = global_1.member.member_13.member_6;
let _e8984 = f32(_e8983);
let _e8986 = select(0f, _e8980, (_e8980 > 0f));
let _e8989 = (select(1f, _e8986, (_e8986 < 1f)) * _e8984);
let _e8990 = (_e8984 - 1f);
let _e8992 = select(0f, _e8990, (_e8990 > 0f));
let _e8994 = select(0f, _e8989, (_e8989 > 0f));
let _e8996 = select(_e8992, _e8994, (_e8994 < _e8992));
let _e9003 = select(0i, select(select(i32(_e8996), i32(-2147483648), (_e8996 < -2147483600f)), 2147483647i, (_e8996 > 2147483500f)), (_e8996 == _e8996));
let _e9007 = (_e9003 - select(0i, 1i, (_e8996 < f32(_e9003))));
if (_e9007 > 0i) {
let _e9010 = local_137;
let _e9011 = local_139;
let _e9014 = local_138;
let _e9015 = ((_e9010 + ((_e9007 - 1i) * _e9011)) + _e9014);
let _e9017 = (bitcast<i32>(_e268) - 1i);
let _e9019 = select(_e9017, _e9015, (_e9015 < _e9017));
let _e9024 = global_7.member[bitcast<u32>(select(0i, _e9019, (_e9019 > 0i)))];
phi_23284_ = _e9024;
} else {
phi_23284_ = 0f;
}
let _e9026 = phi_23284_;
let _e9027 = local_137;
let _e9028 = local_139;
let _e9031 = local_138;
let _e9032 = ((_e9027 + (_e9007 * _e9028)) + _e9031);
let _e9034 = (bitcast<i32>(_e268) - 1i);
let _e9036 = select(_e9034, _e9032, (_e9032 < _e9034));
let _e9041 = global_7.member[bitcast<u32>(select(0i, _e9036, (_e9036 > 0i)))];
let _e9048 = (_e8748 - _e8737);
let _e9051 = ((_e8872 - _e8737) / select(1e-9f, _e9048, (_e9048 > 1e-9f)));
local_134 = 0i;
local_135 = _e8757;
local_136 = _e8723;
let _e9053 = select(0f, _e9051, (_e9051 > 0f));
let _e9056 = (select(1f, _e9053, (_e9053 < 1f)) * _e8984);
let _e9058 = select(0f, _e9056, (_e9056 > 0f));
let _e9060 = select(_e8992, _e9058, (_e9058 < _e8992));
let _e9067 = select(0i, select(select(i32(_e9060), i32(-2147483648), (_e9060 < -2147483600f)), 2147483647i, (_e9060 > 2147483500f)), (_e9060 == _e9060));
let _e9071 = (_e9067 - select(0i, 1i, (_e9060 < f32(_e9067))));
if (_e9071 > 0i) {
let _e9074 = local_134;
let _e9075 = local_136;
let _e9078 = local_135;
let _e9079 = ((_e9074 + ((_e9071 - 1i) * _e9075)) + _e9078);
let _e9081 = select(_e9034, _e9079, (_e9079 < _e9034));
let _e9086 = global_7.member[bitcast<u32>(select(0i, _e9081, (_e9081 > 0i)))];
phi_23411_ = _e9086;
} else {
phi_23411_ = 0f;
}
let _e9088 = phi_23411_;
let _e9089 = local_134;
let _e9090 = local_136;
let _e9093 = local_135;
let _e9094 = ((_e9089 + (_e9071 * _e9090)) + _e9093);
let _e9096 = select(_e9034, _e9094, (_e9094 < _e9034));
let _e9101 = global_7.member[bitcast<u32>(select(0i, _e9096, (_e9096 > 0i)))];
let _e9107 = ((_e9026 + ((_e9041 - _e9026) * (_e8989 - f32(_e9007)))) + (_e9088 + ((_e9101 - _e9088) * (_e9056 - f32(_e9071)))));
let _e9116 = global_1.member.member_13.member_7;
let _e9117 = bitcast<i32>(_e9116);
let _e9120 = global_1.member.member_13.member_8;
let _e9121 = bitcast<i32>(_e9120);
let _e9124 = global_1.member.member_13.member_9;
let _e9125 = bitcast<i32>(_e9124);
let _e9128 = global_1.member.member_13.member_4;
let _e9134 = global_1.member.member_13.member_5;
let _e9138 = f32(_e9117);
let _e9143 = (((((_e8820 + (_e8832 * _e8872)) - _e9128.member) / (_e9134.member - _e9128.member)) * _e9138) - 0.5f);
let _e9144 = (_e9138 - 1f);
let _e9146 = select(0f, _e9143, (_e9143 > 0f));
let _e9148 = select(_e9144, _e9146, (_e9146 < _e9144));
let _e9149 = f32(_e9121);
let _e9154 = (((((_e8821 + (_e8833 * _e8872)) - _e9128.member_1) / (_e9134.member_1 - _e9128.member_1)) * _e9149) - 0.5f);
let _e9155 = (_e9149 - 1f);
let _e9157 = select(0f, _e9154, (_e9154 > 0f));
let _e9159 = select(_e9155, _e9157, (_e9157 < _e9155));
let _e9160 = f32(_e9125);
let _e9165 = (((((_e8822 + (_e8834 * _e8872)) - _e9128.member_2) / (_e9134.member_2 - _e9128.member_2)) * _e9160) - 0.5f);
let _e9166 = (_e9160 - 1f);
let _e9168 = select(0f, _e9165, (_e9165 > 0f));
let _e9170 = select(_e9166, _e9168, (_e9168 < _e9166));
let _e9172 = select(0f, _e9148, (_e9148 > 0f));
let _e9174 = select(1e6f, _e9172, (_e9172 < 1e6f));
let _e9181 = select(0i, select(select(i32(_e9174), i32(-2147483648), (_e9174 < -2147483600f)), 2147483647i, (_e9174 > 2147483500f)), (_e9174 == _e9174));
let _e9185 = (_e9181 - select(0i, 1i, (_e9174 < f32(_e9181))));
let _e9187 = select(0f, _e9159, (_e9159 > 0f));
let _e9189 = select(1e6f, _e9187, (_e9187 < 1e6f));
let _e9196 = select(0i, select(select(i32(_e9189), i32(-2147483648), (_e9189 < -2147483600f)), 2147483647i, (_e9189 > 2147483500f)), (_e9189 == _e9189));
let _e9200 = (_e9196 - select(0i, 1i, (_e9189 < f32(_e9196))));
let _e9202 = select(0f, _e9170, (_e9170 > 0f));
let _e9204 = select(1e6f, _e9202, (_e9202 < 1e6f));
let _e9211 = select(0i, select(select(i32(_e9204), i32(-2147483648), (_e9204 < -2147483600f)), 2147483647i, (_e9204 > 2147483500f)), (_e9204 == _e9204));
let _e9215 = (_e9211 - select(0i, 1i, (_e9204 < f32(_e9211))));
let _e9219 = (_e9159 - f32(_e9200));
let _e9221 = (_e9170 - f32(_e9215));
local_132 = (_e9148 - f32(_e9185));
let _e9222 = (_e9185 + 1i);
let _e9224 = select(_e9222, 0i, (_e9222 < 0i));
if (_e9224 >= _e9117) {
phi_23559_ = (_e9117 - 1i);
} else {
phi_23559_ = _e9224;
}
let _e9228 = phi_23559_;
local_133 = (_e9228 - _e9185);
let _e9230 = (_e9200 + 1i);
let _e9232 = select(_e9230, 0i, (_e9230 < 0i));
if (_e9232 >= _e9121) {
phi_23572_ = (_e9121 - 1i);
} else {
phi_23572_ = _e9232;
}
let _e9236 = phi_23572_;
let _e9238 = ((_e9236 - _e9200) * _e9117);
let _e9239 = (_e9215 + 1i);
let _e9241 = select(_e9239, 0i, (_e9239 < 0i));
if (_e9241 >= _e9125) {
phi_23586_ = (_e9125 - 1i);
} else {
phi_23586_ = _e9241;
}
let _e9245 = phi_23586_;
let _e9251 = global_1.member.member_13.member_10;
let _e9257 = ((bitcast<i32>(_e9251) + (((_e9215 * _e9121) + _e9200) * _e9117)) + _e9185);
let _e9259 = (bitcast<i32>(_e265) - 1i);
let _e9261 = select(_e9259, _e9257, (_e9257 < _e9259));
let _e9266 = global_2.member[bitcast<u32>(select(0i, _e9261, (_e9261 > 0i)))];
let _e9267 = local_132;
let _e9270 = local_133;
let _e9271 = (_e9257 + _e9270);
let _e9273 = select(_e9259, _e9271, (_e9271 < _e9259));
let _e9278 = global_2.member[bitcast<u32>(select(0i, _e9273, (_e9273 > 0i)))];
let _e9279 = local_132;
let _e9282 = (1f - _e9219);
let _e9284 = (_e9257 + _e9238);
let _e9286 = select(_e9259, _e9284, (_e9284 < _e9259));
let _e9291 = global_2.member[bitcast<u32>(select(0i, _e9286, (_e9286 > 0i)))];
let _e9292 = local_132;
let _e9295 = local_133;
let _e9296 = (_e9284 + _e9295);
let _e9298 = select(_e9259, _e9296, (_e9296 < _e9259));
let _e9303 = global_2.member[bitcast<u32>(select(0i, _e9298, (_e9298 > 0i)))];
let _e9304 = local_132;
let _e9309 = (_e9257 + (((_e9245 - _e9215) * _e9117) * _e9121));
let _e9311 = select(_e9259, _e9309, (_e9309 < _e9259));
let _e9316 = global_2.member[bitcast<u32>(select(0i, _e9311, (_e9311 > 0i)))];
let _e9317 = local_132;
let _e9320 = local_133;
let _e9321 = (_e9309 + _e9320);
let _e9323 = select(_e9259, _e9321, (_e9321 < _e9259));
let _e9328 = global_2.member[bitcast<u32>(select(0i, _e9323, (_e9323 > 0i)))];
let _e9329 = local_132;
let _e9333 = (_e9309 + _e9238);
let _e9335 = select(_e9259, _e9333, (_e9333 < _e9259));
let _e9340 = global_2.member[bitcast<u32>(select(0i, _e9335, (_e9335 > 0i)))];
let _e9341 = local_132;
let _e9344 = local_133;
let _e9345 = (_e9333 + _e9344);
let _e9347 = select(_e9259, _e9345, (_e9345 < _e9259));
let _e9352 = global_2.member[bitcast<u32>(select(0i, _e9347, (_e9347 > 0i)))];
let _e9353 = local_132;
let _e9362 = ((_e8830 * (_e8960 * (0.25f / 3.1415927f))) * ((((((_e9266 * (1f - _e9267)) + (_e9278 * _e9279)) * _e9282) + (((_e9291 * (1f - _e9292)) + (_e9303 * _e9304)) * _e9219)) * (1f - _e9221)) + (((((_e9316 * (1f - _e9317)) + (_e9328 * _e9329)) * _e9282) + (((_e9340 * (1f - _e9341)) + (_e9352 * _e9353)) * _e9219)) * _e9221)));
let _e9365 = global_1.member.member_13.member_1;
let _e9374 = global_1.member.member_13.member;
let _e9379 = -((_e9374.member * _e9107));
let _e9381 = select(-87f, _e9379, (_e9379 > -87f));
let _e9383 = select(88f, _e9381, (_e9381 < 88f));
let _e9385 = ((_e9383 * 1.442695f) + 0.5f);
let _e9387 = select(-127f, _e9385, (_e9385 > -127f));
let _e9389 = select(128f, _e9387, (_e9387 < 128f));
let _e9396 = select(0i, select(select(i32(_e9389), i32(-2147483648), (_e9389 < -2147483600f)), 2147483647i, (_e9389 > 2147483500f)), (_e9389 == _e9389));
let _e9400 = (_e9396 - select(0i, 1i, (_e9389 < f32(_e9396))));
let _e9401 = f32(_e9400);
let _e9405 = ((_e9383 - (_e9401 * 0.6933594f)) - (_e9401 * -2.1219444e-4f));
let _e9427 = -((_e9374.member_1 * _e9107));
let _e9429 = select(-87f, _e9427, (_e9427 > -87f));
let _e9431 = select(88f, _e9429, (_e9429 < 88f));
let _e9433 = ((_e9431 * 1.442695f) + 0.5f);
let _e9435 = select(-127f, _e9433, (_e9433 > -127f));
let _e9437 = select(128f, _e9435, (_e9435 < 128f));
let _e9444 = select(0i, select(select(i32(_e9437), i32(-2147483648), (_e9437 < -2147483600f)), 2147483647i, (_e9437 > 2147483500f)), (_e9437 == _e9437));
let _e9448 = (_e9444 - select(0i, 1i, (_e9437 < f32(_e9444))));
let _e9449 = f32(_e9448);
let _e9453 = ((_e9431 - (_e9449 * 0.6933594f)) - (_e9449 * -2.1219444e-4f));
let _e9475 = -((_e9374.member_2 * _e9107));
let _e9477 = select(-87f, _e9475, (_e9475 > -87f));
let _e9479 = select(88f, _e9477, (_e9477 < 88f));
let _e9481 = ((_e9479 * 1.442695f) + 0.5f);
let _e9483 = select(-127f, _e9481, (_e9481 > -127f));
let _e9485 = select(128f, _e9483, (_e9483 < 128f));
let _e9492 = select(0i, select(select(i32(_e9485), i32(-2147483648), (_e9485 < -2147483600f)), 2147483647i, (_e9485 > 2147483500f)), (_e9485 == _e9485));
let _e9496 = (_e9492 - select(0i, 1i, (_e9485 < f32(_e9492))));
let _e9497 = f32(_e9496);
let _e9501 = ((_e9479 - (_e9497 * 0.6933594f)) - (_e9497 * -2.1219444e-4f));
let _e9528 = select(0f, _e8872, (((_e8875 >= 0f) && (_e8875 < _e691)) && (_e8872 > 0f)));
if _e453 {
phi_24021_ = type_23(_e8665, _e8572);
} else {
phi_24021_ = type_23(_e8572, _e8665);
}
let _e9539 = phi_24021_;
let _e9542 = (_e8666 && (((_e9528 > 0f) && (_e9528 < _e8756)) && true));
let _e9545 = global_1.member.member_18.member;
let _e9546 = (((select(_e8691, (1f - _e8691), (_e8676 >= 0f)) - select(_e8710, (1f - _e8710), (_e8695 >= 0f))) * (1f / _e8673)) * _e9545);
let _e9550 = select(0f, (((((_e652 * _e9365.member) * ((1f + (_e9405 * (1f + (_e9405 * (0.5f + (_e9405 * (0.16666667f + (_e9405 * (0.041666668f + (_e9405 * (0.008333334f + (_e9405 * (0.001388889f + (_e9405 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9400 + 127i)) << bitcast<u32>(23i))))) * _e9362) * 1f) * _e9546), _e9542);
let _e9551 = select(0f, (((((_e665 * _e9365.member_1) * ((1f + (_e9453 * (1f + (_e9453 * (0.5f + (_e9453 * (0.16666667f + (_e9453 * (0.041666668f + (_e9453 * (0.008333334f + (_e9453 * (0.001388889f + (_e9453 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9448 + 127i)) << bitcast<u32>(23i))))) * _e9362) * 1f) * _e9546), _e9542);
let _e9552 = select(0f, (((((_e678 * _e9365.member_2) * ((1f + (_e9501 * (1f + (_e9501 * (0.5f + (_e9501 * (0.16666667f + (_e9501 * (0.041666668f + (_e9501 * (0.008333334f + (_e9501 * (0.001388889f + (_e9501 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9496 + 127i)) << bitcast<u32>(23i))))) * _e9362) * 1f) * _e9546), _e9542);
let _e9556 = (bitcast<f32>((bitcast<u32>(_e9550) & 2147483647u)) >= 1073741800f);
let _e9557 = (1f / 1048576f);
let _e9560 = ((_e9550 * select(1f, _e9557, _e9556)) + 0.5f);
let _e9562 = select(-1073741800f, _e9560, (_e9560 > -1073741800f));
let _e9564 = select(1073741800f, _e9562, (_e9562 < 1073741800f));
let _e9571 = select(0i, select(select(i32(_e9564), i32(-2147483648), (_e9564 < -2147483600f)), 2147483647i, (_e9564 > 2147483500f)), (_e9564 == _e9564));
let _e9575 = (_e9571 - select(0i, 1i, (_e9564 < f32(_e9571))));
let _e9576 = select(0i, 20i, _e9556);
let _e9580 = (bitcast<u32>(_e9575) << bitcast<u32>((_e9576 & 31i)));
let _e9587 = bitcast<u32>(((_e9575 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9576) & 31i))));
let _e9591 = (bitcast<f32>((bitcast<u32>(_e9551) & 2147483647u)) >= 1073741800f);
let _e9594 = ((_e9551 * select(1f, _e9557, _e9591)) + 0.5f);
let _e9596 = select(-1073741800f, _e9594, (_e9594 > -1073741800f));
let _e9598 = select(1073741800f, _e9596, (_e9596 < 1073741800f));
let _e9605 = select(0i, select(select(i32(_e9598), i32(-2147483648), (_e9598 < -2147483600f)), 2147483647i, (_e9598 > 2147483500f)), (_e9598 == _e9598));
let _e9609 = (_e9605 - select(0i, 1i, (_e9598 < f32(_e9605))));
let _e9610 = select(0i, 20i, _e9591);
let _e9614 = (bitcast<u32>(_e9609) << bitcast<u32>((_e9610 & 31i)));
let _e9621 = bitcast<u32>(((_e9609 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9610) & 31i))));
let _e9625 = (bitcast<f32>((bitcast<u32>(_e9552) & 2147483647u)) >= 1073741800f);
let _e9628 = ((_e9552 * select(1f, _e9557, _e9625)) + 0.5f);
let _e9630 = select(-1073741800f, _e9628, (_e9628 > -1073741800f));
let _e9632 = select(1073741800f, _e9630, (_e9630 < 1073741800f));
let _e9639 = select(0i, select(select(i32(_e9632), i32(-2147483648), (_e9632 < -2147483600f)), 2147483647i, (_e9632 > 2147483500f)), (_e9632 == _e9632));
let _e9643 = (_e9639 - select(0i, 1i, (_e9632 < f32(_e9639))));
let _e9644 = select(0i, 20i, _e9625);
let _e9648 = (bitcast<u32>(_e9643) << bitcast<u32>((_e9644 & 31i)));
let _e9655 = bitcast<u32>(((_e9643 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9644) & 31i))));
let _e9660 = bitcast<i32>(bitcast<u32>((((_e9539.member_1 * _e935) + _e9539.member) * 6i)));
if ((_e9580 | _e9587) == 0u) {
} else {
let _e9663 = bitcast<u32>(_e9660);
if (_e9663 < _e270) {
let _e9667 = atomicAdd((&global_8.member[_e9663]), _e9580);
phi_24254_ = _e9667;
} else {
phi_24254_ = 0u;
}
let _e9669 = phi_24254_;
let _e9673 = (_e9587 + select(0u, 1u, ((_e9669 + _e9580) < _e9580)));
if (_e9673 == 0u) {
} else {
let _e9675 = (_e9663 + 1u);
if (_e9675 < _e270) {
let _e9679 = atomicAdd((&global_8.member[_e9675]), _e9673);
}
}
}
if ((_e9614 | _e9621) == 0u) {
} else {
let _e9683 = bitcast<u32>((_e9660 + 2i));
if (_e9683 < _e270) {
let _e9687 = atomicAdd((&global_8.member[_e9683]), _e9614);
phi_24284_ = _e9687;
} else {
phi_24284_ = 0u;
}
let _e9689 = phi_24284_;
let _e9693 = (_e9621 + select(0u, 1u, ((_e9689 + _e9614) < _e9614)));
if (_e9693 == 0u) {
} else {
let _e9695 = (_e9683 + 1u);
if (_e9695 < _e270) {
let _e9699 = atomicAdd((&global_8.member[_e9695]), _e9693);
}
}
}
if ((_e9648 | _e9655) == 0u) {
} else {
let _e9703 = bitcast<u32>((_e9660 + 4i));
if (_e9703 < _e270) {
let _e9707 = atomicAdd((&global_8.member[_e9703]), _e9648);
phi_24314_ = _e9707;
} else {
phi_24314_ = 0u;
}
let _e9709 = phi_24314_;
let _e9713 = (_e9655 + select(0u, 1u, ((_e9709 + _e9648) < _e9648)));
if (_e9713 == 0u) {
} else {
let _e9715 = (_e9703 + 1u);
if (_e9715 < _e270) {
let _e9719 = atomicAdd((&global_8.member[_e9715]), _e9713);
}
}
}
phi_22647_ = (_e8663 + 1i);
} else {
phi_22647_ = i32();
}
let _e9722 = phi_22647_;
continue;
continuing {
phi_22646_ = _e9722;
break if !(_e8666);
}
}
phi_22493_ = (_e8569 + 1i);
} else {
phi_22493_ = i32();
}
let _e9726 = phi_22493_;
continue;
continuing {
phi_22492_ = _e9726;
break if !(_e8570);
}
}
} else {
if (_e8566 == 1u) {
phi_24363_ = 0i;
loop {
let _e9730 = phi_24363_;
let _e9731 = (_e9730 < 16i);
if _e9731 {
let _e9733 = (_e980 + (_e9730 & 15i));
let _e9735 = (f32(_e9733) + 0.5f);
let _e9737 = ((_e9735 * 1f) - 0.5f);
let _e9741 = (-(((_e416 * _e9737) + _e442)) / _e429);
let _e9748 = bitcast<f32>((bitcast<u32>(((_e466 * _e9737) + ((_e479 * _e9741) + _e492))) & 2147483647u));
let _e9755 = bitcast<f32>((bitcast<u32>(((_e505 * _e9737) + ((_e518 * _e9741) + _e531))) & 2147483647u));
let _e9759 = (((0.5f * (_e9748 + _e9755)) / _e534) + _e717);
let _e9760 = (1f / 1f);
let _e9768 = ((((_e9741 + _e9759) + 0.5f) * _e9760) - 0.5f);
let _e9769 = f32(_e8552);
let _e9770 = f32(_e8550);
let _e9771 = (_e9769 - 1f);
let _e9773 = select(_e9771, _e9768, (_e9768 > _e9771));
let _e9775 = select(_e9770, _e9773, (_e9773 < _e9770));
let _e9782 = select(0i, select(select(i32(_e9775), i32(-2147483648), (_e9775 < -2147483600f)), 2147483647i, (_e9775 > 2147483500f)), (_e9775 == _e9775));
let _e9787 = (((((_e9741 - _e9759) + 0.5f) * _e9760) - 0.5f) + 1f);
let _e9788 = (_e9770 + 1f);
let _e9790 = select(_e9769, _e9787, (_e9787 > _e9769));
let _e9792 = select(_e9788, _e9790, (_e9790 < _e9788));
let _e9799 = select(0i, select(select(i32(_e9792), i32(-2147483648), (_e9792 < -2147483600f)), 2147483647i, (_e9792 > 2147483500f)), (_e9792 == _e9792));
let _e9810 = ((1e-4f * 1f) * _e534);
let _e9812 = select(_e9755, _e9748, (_e9748 > _e9755));
let _e9814 = select(_e9810, _e9812, (_e9812 > _e9810));
let _e9816 = select(_e9755, _e9748, (_e9748 < _e9755));
let _e9818 = select(_e9810, _e9816, (_e9816 > _e9810));
let _e9820 = (0.5f * (_e9814 + _e9818));
let _e9821 = (0.5f / _e9818);
let _e9822 = (1f / _e9814);
phi_24517_ = 0i;
loop {
let _e9824 = phi_24517_;
let _e9826 = (((_e9799 - select(0i, 1i, (_e9792 < f32(_e9799)))) + (_e9730 >> bitcast<u32>(4u))) + bitcast<i32>(_e9824));
let _e9827 = (_e9826 <= select(-1i, (_e9782 - select(0i, 1i, (_e9775 < f32(_e9782)))), (_e9733 <= _e984)));
if _e9827 {
let _e9829 = (f32(_e9826) + 0.5f);
let _e9833 = ((((_e9829 * 1f) - 0.5f) - _e9741) * _e534);
let _e9834 = (_e534 * 1f);
let _e9836 = (0.5f * _e9834);
let _e9837 = (_e9833 + _e9836);
let _e9838 = -(_e9837);
let _e9841 = (_e9820 - select(_e9838, _e9837, (_e9837 > _e9838)));
let _e9843 = select(0f, _e9841, (_e9841 > 0f));
let _e9845 = select(_e9818, _e9843, (_e9843 < _e9818));
let _e9848 = (_e9841 - _e9818);
let _e9852 = (((_e9845 * (_e9845 * _e9821)) + select(0f, _e9848, (_e9848 > 0f))) * _e9822);
let _e9856 = (_e9833 - _e9836);
let _e9857 = -(_e9856);
let _e9860 = (_e9820 - select(_e9857, _e9856, (_e9856 > _e9857)));
let _e9862 = select(0f, _e9860, (_e9860 > 0f));
let _e9864 = select(_e9818, _e9862, (_e9862 < _e9818));
let _e9867 = (_e9860 - _e9818);
let _e9871 = (((_e9864 * (_e9864 * _e9821)) + select(0f, _e9867, (_e9867 > 0f))) * _e9822);
if _e453 {
phi_24622_ = type_23(_e9826, _e9733);
} else {
phi_24622_ = type_23(_e9733, _e9826);
}
let _e9880 = phi_24622_;
let _e9884 = bitcast<i32>((_e931 * _e934));
local_130 = _e9884;
local_131 = ((_e9880.member_1 * _e935) + _e9880.member);
let _e9887 = local_130;
let _e9888 = local_131;
let _e9889 = (_e9887 + _e9888);
let _e9891 = (bitcast<i32>(_e259) - 1i);
let _e9893 = select(_e9891, _e9889, (_e9889 < _e9891));
let _e9898 = global_5.member[bitcast<u32>(select(0i, _e9893, (_e9893 > 0i)))];
let _e9899 = local_130;
let _e9901 = local_131;
let _e9902 = ((2i * _e9899) + _e9901);
let _e9904 = select(_e9891, _e9902, (_e9902 < _e9891));
let _e9909 = global_5.member[bitcast<u32>(select(0i, _e9904, (_e9904 > 0i)))];
let _e9910 = local_131;
let _e9912 = select(_e9891, _e9910, (_e9910 < _e9891));
let _e9917 = global_5.member[bitcast<u32>(select(0i, _e9912, (_e9912 > 0i)))];
let _e9918 = local_131;
let _e9921 = f32(_e935);
let _e9922 = f32(_e936);
let _e9929 = global_1.member.member_2.member;
let _e9930 = (((((f32(_e9880.member) + 0.5f) / _e9921) * 2f) - 1f) * _e9929);
let _e9937 = global_1.member.member_2.member_1;
let _e9938 = ((1f - (((f32(_e9880.member_1) + 0.5f) / _e9922) * 2f)) * _e9937);
let _e9940 = global_1.member.member_3;
let _e9948 = global_1.member.member_4;
let _e9955 = ((_e9940.member * _e9930) + (_e9948.member * _e9938));
let _e9956 = ((_e9940.member_1 * _e9930) + (_e9948.member_1 * _e9938));
let _e9957 = ((_e9940.member_2 * _e9930) + (_e9948.member_2 * _e9938));
let _e9960 = global_1.member.member_2.member_3;
let _e9961 = (_e9960 != 0u);
let _e9963 = global_1.member.member_5;
let _e9970 = select((_e9963.member + _e9955), _e9963.member, _e9961);
let _e9971 = select((_e9963.member_1 + _e9956), _e9963.member_1, _e9961);
let _e9972 = select((_e9963.member_2 + _e9957), _e9963.member_2, _e9961);
let _e9974 = global_1.member.member_6;
let _e9981 = select(_e9974.member, (_e9974.member + _e9955), _e9961);
let _e9982 = select(_e9974.member_1, (_e9974.member_1 + _e9956), _e9961);
let _e9983 = select(_e9974.member_2, (_e9974.member_2 + _e9957), _e9961);
let _e9988 = (((_e9970 * _e9970) + (_e9971 * _e9971)) + (_e9972 * _e9972));
let _e9991 = sqrt(select(0f, _e9988, (_e9988 > 0f)));
let _e9992 = (1f / _e9991);
let _e9993 = (_e9970 * _e9992);
let _e9994 = (_e9971 * _e9992);
let _e9995 = (_e9972 * _e9992);
let _e9996 = (_e575 - _e9981);
let _e9997 = (_e587 - _e9982);
let _e9998 = (_e600 - _e9983);
let _e10003 = (((_e9996 * _e9993) + (_e9997 * _e9994)) + (_e9998 * _e9995));
let _e10008 = (((_e9996 * _e613) + (_e9997 * _e626)) + (_e9998 * _e639));
let _e10013 = (((_e9993 * _e613) + (_e9994 * _e626)) + (_e9995 * _e639));
let _e10016 = ((_e9994 * _e639) - (_e9995 * _e626));
let _e10019 = ((_e9995 * _e613) - (_e9993 * _e639));
let _e10022 = ((_e9993 * _e626) - (_e9994 * _e613));
let _e10027 = (((_e10016 * _e10016) + (_e10019 * _e10019)) + (_e10022 * _e10022));
let _e10030 = (1f / select(1e-9f, _e10027, (_e10027 > 1e-9f)));
let _e10033 = ((_e10003 - (_e10013 * _e10008)) * _e10030);
let _e10036 = (((_e10013 * _e10003) - _e10008) * _e10030);
let _e10042 = -(_e10013);
let _e10045 = global_1.member.member_13.member_2;
let _e10046 = (_e10045 * _e10045);
let _e10050 = ((1f + _e10046) - ((2f * _e10045) * _e10042));
let _e10052 = select(1e-9f, _e10050, (_e10050 > 1e-9f));
let _e10064 = global_1.member.member_13.member_3;
if (_e10064 == 2u) {
let _e10069 = (0.5f - (0.5f * _e10042));
let _e10071 = select(0f, _e10069, (_e10069 > 0f));
let _e10075 = (sqrt(select(0f, _e10071, (_e10071 > 0f))) * 255f);
let _e10076 = (255f - 1f);
let _e10078 = select(0f, _e10075, (_e10075 > 0f));
let _e10080 = select(_e10076, _e10078, (_e10078 < _e10076));
let _e10087 = select(0i, select(select(i32(_e10080), i32(-2147483648), (_e10080 < -2147483600f)), 2147483647i, (_e10080 > 2147483500f)), (_e10080 == _e10080));
let _e10091 = (_e10087 - select(0i, 1i, (_e10080 < f32(_e10087))));
let _e10094 = global_1.member.member_13.member_11;
let _e10095 = bitcast<i32>(_e10094);
let _e10096 = (_e10095 + _e10091);
let _e10098 = (bitcast<i32>(_e265) - 1i);
let _e10100 = select(_e10098, _e10096, (_e10096 < _e10098));
let _e10105 = global_2.member[bitcast<u32>(select(0i, _e10100, (_e10100 > 0i)))];
let _e10107 = (_e10095 + (_e10091 + 1i));
let _e10109 = select(_e10098, _e10107, (_e10107 < _e10098));
let _e10114 = global_2.member[bitcast<u32>(select(0i, _e10109, (_e10109 > 0i)))];
phi_25049_ = (_e10105 + ((_e10114 - _e10105) * (_e10075 - f32(_e10091))));
} else {
phi_25049_ = select(((1f - _e10046) / (_e10052 * sqrt(select(0f, _e10052, (_e10052 > 0f))))), (0.75f * (1f + (_e10042 * _e10042))), (_e10064 == 1u));
}
let _e10121 = phi_25049_;
let _e10127 = global_1.member.member_12.member_11;
let _e10130 = global_1.member.member_12.member_4;
let _e10133 = global_1.member.member_12.member_12;
let _e10139 = global_1.member.member.member;
let _e10141 = (_e10036 / _e691);
local_127 = bitcast<i32>((_e10127 + (_e10130 * _e10133)));
local_128 = _e281;
local_129 = bitcast<i32>(_e10139);
let _e10144 = global_1.member.member_13.member_6;
let _e10145 = f32(_e10144);
let _e10147 = select(0f, _e10141, (_e10141 > 0f));
let _e10150 = (select(1f, _e10147, (_e10147 < 1f)) * _e10145);
let _e10151 = (_e10145 - 1f);
let _e10153 = select(0f, _e10151, (_e10151 > 0f));
let _e10155 = select(0f, _e10150, (_e10150 > 0f));
let _e10157 = select(_e10153, _e10155, (_e10155 < _e10153));
let _e10164 = select(0i, select(select(i32(_e10157), i32(-2147483648), (_e10157 < -2147483600f)), 2147483647i, (_e10157 > 2147483500f)), (_e10157 == _e10157));
let _e10168 = (_e10164 - select(0i, 1i, (_e10157 < f32(_e10164))));
if (_e10168 > 0i) {
let _e10171 = local_127;
let _e10172 = local_129;
let _e10175 = local_128;
let _e10176 = ((_e10171 + ((_e10168 - 1i) * _e10172)) + _e10175);
let _e10178 = (bitcast<i32>(_e268) - 1i);
let _e10180 = select(_e10178, _e10176, (_e10176 < _e10178));
let _e10185 = global_7.member[bitcast<u32>(select(0i, _e10180, (_e10180 > 0i)))];
phi_25155_ = _e10185;
} else {
phi_25155_ = 0f;
}
let _e10187 = phi_25155_;
let _e10188 = local_127;
let _e10189 = local_129;
let _e10192 = local_128;
let _e10193 = ((_e10188 + (_e10168 * _e10189)) + _e10192);
let _e10195 = (bitcast<i32>(_e268) - 1i);
let _e10197 = select(_e10195, _e10193, (_e10193 < _e10195));
let _e10202 = global_7.member[bitcast<u32>(select(0i, _e10197, (_e10197 > 0i)))];
let _e10209 = (_e9909 - _e9898);
let _e10212 = ((_e10033 - _e9898) / select(1e-9f, _e10209, (_e10209 > 1e-9f)));
local_124 = 0i;
local_125 = _e9918;
local_126 = _e9884;
let _e10214 = select(0f, _e10212, (_e10212 > 0f));
let _e10217 = (select(1f, _e10214, (_e10214 < 1f)) * _e10145);
let _e10219 = select(0f, _e10217, (_e10217 > 0f));
let _e10221 = select(_e10153, _e10219, (_e10219 < _e10153));
let _e10228 = select(0i, select(select(i32(_e10221), i32(-2147483648), (_e10221 < -2147483600f)), 2147483647i, (_e10221 > 2147483500f)), (_e10221 == _e10221));
let _e10232 = (_e10228 - select(0i, 1i, (_e10221 < f32(_e10228))));
if (_e10232 > 0i) {
let _e10235 = local_124;
let _e10236 = local_126;
let _e10239 = local_125;
let _e10240 = ((_e10235 + ((_e10232 - 1i) * _e10236)) + _e10239);
let _e10242 = select(_e10195, _e10240, (_e10240 < _e10195));
let _e10247 = global_7.member[bitcast<u32>(select(0i, _e10242, (_e10242 > 0i)))];
phi_25282_ = _e10247;
} else {
phi_25282_ = 0f;
}
let _e10249 = phi_25282_;
let _e10250 = local_124;
let _e10251 = local_126;
let _e10254 = local_125;
let _e10255 = ((_e10250 + (_e10232 * _e10251)) + _e10254);
let _e10257 = select(_e10195, _e10255, (_e10255 < _e10195));
let _e10262 = global_7.member[bitcast<u32>(select(0i, _e10257, (_e10257 > 0i)))];
let _e10268 = ((_e10187 + ((_e10202 - _e10187) * (_e10150 - f32(_e10168)))) + (_e10249 + ((_e10262 - _e10249) * (_e10217 - f32(_e10232)))));
let _e10277 = global_1.member.member_13.member_7;
let _e10278 = bitcast<i32>(_e10277);
let _e10281 = global_1.member.member_13.member_8;
let _e10282 = bitcast<i32>(_e10281);
let _e10285 = global_1.member.member_13.member_9;
let _e10286 = bitcast<i32>(_e10285);
let _e10289 = global_1.member.member_13.member_4;
let _e10295 = global_1.member.member_13.member_5;
let _e10299 = f32(_e10278);
let _e10304 = (((((_e9981 + (_e9993 * _e10033)) - _e10289.member) / (_e10295.member - _e10289.member)) * _e10299) - 0.5f);
let _e10305 = (_e10299 - 1f);
let _e10307 = select(0f, _e10304, (_e10304 > 0f));
let _e10309 = select(_e10305, _e10307, (_e10307 < _e10305));
let _e10310 = f32(_e10282);
let _e10315 = (((((_e9982 + (_e9994 * _e10033)) - _e10289.member_1) / (_e10295.member_1 - _e10289.member_1)) * _e10310) - 0.5f);
let _e10316 = (_e10310 - 1f);
let _e10318 = select(0f, _e10315, (_e10315 > 0f));
let _e10320 = select(_e10316, _e10318, (_e10318 < _e10316));
let _e10321 = f32(_e10286);
let _e10326 = (((((_e9983 + (_e9995 * _e10033)) - _e10289.member_2) / (_e10295.member_2 - _e10289.member_2)) * _e10321) - 0.5f);
let _e10327 = (_e10321 - 1f);
let _e10329 = select(0f, _e10326, (_e10326 > 0f));
let _e10331 = select(_e10327, _e10329, (_e10329 < _e10327));
let _e10333 = select(0f, _e10309, (_e10309 > 0f));
let _e10335 = select(1e6f, _e10333, (_e10333 < 1e6f));
let _e10342 = select(0i, select(select(i32(_e10335), i32(-2147483648), (_e10335 < -2147483600f)), 2147483647i, (_e10335 > 2147483500f)), (_e10335 == _e10335));
let _e10346 = (_e10342 - select(0i, 1i, (_e10335 < f32(_e10342))));
let _e10348 = select(0f, _e10320, (_e10320 > 0f));
let _e10350 = select(1e6f, _e10348, (_e10348 < 1e6f));
let _e10357 = select(0i, select(select(i32(_e10350), i32(-2147483648), (_e10350 < -2147483600f)), 2147483647i, (_e10350 > 2147483500f)), (_e10350 == _e10350));
let _e10361 = (_e10357 - select(0i, 1i, (_e10350 < f32(_e10357))));
let _e10363 = select(0f, _e10331, (_e10331 > 0f));
let _e10365 = select(1e6f, _e10363, (_e10363 < 1e6f));
let _e10372 = select(0i, select(select(i32(_e10365), i32(-2147483648), (_e10365 < -2147483600f)), 2147483647i, (_e10365 > 2147483500f)), (_e10365 == _e10365));
let _e10376 = (_e10372 - select(0i, 1i, (_e10365 < f32(_e10372))));
let _e10380 = (_e10320 - f32(_e10361));
let _e10382 = (_e10331 - f32(_e10376));
local_122 = (_e10309 - f32(_e10346));
let _e10383 = (_e10346 + 1i);
let _e10385 = select(_e10383, 0i, (_e10383 < 0i));
if (_e10385 >= _e10278) {
phi_25430_ = (_e10278 - 1i);
} else {
phi_25430_ = _e10385;
}
let _e10389 = phi_25430_;
local_123 = (_e10389 - _e10346);
let _e10391 = (_e10361 + 1i);
let _e10393 = select(_e10391, 0i, (_e10391 < 0i));
if (_e10393 >= _e10282) {
phi_25443_ = (_e10282 - 1i);
} else {
phi_25443_ = _e10393;
}
let _e10397 = phi_25443_;
let _e10399 = ((_e10397 - _e10361) * _e10278);
let _e10400 = (_e10376 + 1i);
let _e10402 = select(_e10400, 0i, (_e10400 < 0i));
if (_e10402 >= _e10286) {
phi_25457_ = (_e10286 - 1i);
} else {
phi_25457_ = _e10402;
}
let _e10406 = phi_25457_;
let _e10412 = global_1.member.member_13.member_10;
let _e10418 = ((bitcast<i32>(_e10412) + (((_e10376 * _e10282) + _e10361) * _e10278)) + _e10346);
let _e10420 = (bitcast<i32>(_e265) - 1i);
let _e10422 = select(_e10420, _e10418, (_e10418 < _e10420));
let _e10427 = global_2.member[bitcast<u32>(select(0i, _e10422, (_e10422 > 0i)))];
let _e10428 = local_122;
let _e10431 = local_123;
let _e10432 = (_e10418 + _e10431);
let _e10434 = select(_e10420, _e10432, (_e10432 < _e10420));
let _e10439 = global_2.member[bitcast<u32>(select(0i, _e10434, (_e10434 > 0i)))];
let _e10440 = local_122;
let _e10443 = (1f - _e10380);
let _e10445 = (_e10418 + _e10399);
let _e10447 = select(_e10420, _e10445, (_e10445 < _e10420));
let _e10452 = global_2.member[bitcast<u32>(select(0i, _e10447, (_e10447 > 0i)))];
let _e10453 = local_122;
let _e10456 = local_123;
let _e10457 = (_e10445 + _e10456);
let _e10459 = select(_e10420, _e10457, (_e10457 < _e10420));
let _e10464 = global_2.member[bitcast<u32>(select(0i, _e10459, (_e10459 > 0i)))];
let _e10465 = local_122;
let _e10470 = (_e10418 + (((_e10406 - _e10376) * _e10278) * _e10282));
let _e10472 = select(_e10420, _e10470, (_e10470 < _e10420));
let _e10477 = global_2.member[bitcast<u32>(select(0i, _e10472, (_e10472 > 0i)))];
let _e10478 = local_122;
let _e10481 = local_123;
let _e10482 = (_e10470 + _e10481);
let _e10484 = select(_e10420, _e10482, (_e10482 < _e10420));
let _e10489 = global_2.member[bitcast<u32>(select(0i, _e10484, (_e10484 > 0i)))];
let _e10490 = local_122;
let _e10494 = (_e10470 + _e10399);
let _e10496 = select(_e10420, _e10494, (_e10494 < _e10420));
let _e10501 = global_2.member[bitcast<u32>(select(0i, _e10496, (_e10496 > 0i)))];
let _e10502 = local_122;
let _e10505 = local_123;
let _e10506 = (_e10494 + _e10505);
let _e10508 = select(_e10420, _e10506, (_e10506 < _e10420));
let _e10513 = global_2.member[bitcast<u32>(select(0i, _e10508, (_e10508 > 0i)))];
let _e10514 = local_122;
let _e10523 = ((_e9991 * (_e10121 * (0.25f / 3.1415927f))) * ((((((_e10427 * (1f - _e10428)) + (_e10439 * _e10440)) * _e10443) + (((_e10452 * (1f - _e10453)) + (_e10464 * _e10465)) * _e10380)) * (1f - _e10382)) + (((((_e10477 * (1f - _e10478)) + (_e10489 * _e10490)) * _e10443) + (((_e10501 * (1f - _e10502)) + (_e10513 * _e10514)) * _e10380)) * _e10382)));
let _e10526 = global_1.member.member_13.member_1;
let _e10535 = global_1.member.member_13.member;
let _e10540 = -((_e10535.member * _e10268));
let _e10542 = select(-87f, _e10540, (_e10540 > -87f));
let _e10544 = select(88f, _e10542, (_e10542 < 88f));
let _e10546 = ((_e10544 * 1.442695f) + 0.5f);
let _e10548 = select(-127f, _e10546, (_e10546 > -127f));
let _e10550 = select(128f, _e10548, (_e10548 < 128f));
let _e10557 = select(0i, select(select(i32(_e10550), i32(-2147483648), (_e10550 < -2147483600f)), 2147483647i, (_e10550 > 2147483500f)), (_e10550 == _e10550));
let _e10561 = (_e10557 - select(0i, 1i, (_e10550 < f32(_e10557))));
let _e10562 = f32(_e10561);
let _e10566 = ((_e10544 - (_e10562 * 0.6933594f)) - (_e10562 * -2.1219444e-4f));
let _e10588 = -((_e10535.member_1 * _e10268));
let _e10590 = select(-87f, _e10588, (_e10588 > -87f));
let _e10592 = select(88f, _e10590, (_e10590 < 88f));
let _e10594 = ((_e10592 * 1.442695f) + 0.5f);
let _e10596 = select(-127f, _e10594, (_e10594 > -127f));
let _e10598 = select(128f, _e10596, (_e10596 < 128f));
let _e10605 = select(0i, select(select(i32(_e10598), i32(-2147483648), (_e10598 < -2147483600f)), 2147483647i, (_e10598 > 2147483500f)), (_e10598 == _e10598));
let _e10609 = (_e10605 - select(0i, 1i, (_e10598 < f32(_e10605))));
let _e10610 = f32(_e10609);
let _e10614 = ((_e10592 - (_e10610 * 0.6933594f)) - (_e10610 * -2.1219444e-4f));
let _e10636 = -((_e10535.member_2 * _e10268));
let _e10638 = select(-87f, _e10636, (_e10636 > -87f));
let _e10640 = select(88f, _e10638, (_e10638 < 88f));
let _e10642 = ((_e10640 * 1.442695f) + 0.5f);
let _e10644 = select(-127f, _e10642, (_e10642 > -127f));
let _e10646 = select(128f, _e10644, (_e10644 < 128f));
let _e10653 = select(0i, select(select(i32(_e10646), i32(-2147483648), (_e10646 < -2147483600f)), 2147483647i, (_e10646 > 2147483500f)), (_e10646 == _e10646));
let _e10657 = (_e10653 - select(0i, 1i, (_e10646 < f32(_e10653))));
let _e10658 = f32(_e10657);
let _e10662 = ((_e10640 - (_e10658 * 0.6933594f)) - (_e10658 * -2.1219444e-4f));
let _e10689 = select(0f, _e10033, (((_e10036 >= 0f) && (_e10036 < _e691)) && (_e10033 > 0f)));
let _e10691 = ((_e766 + _e8554) + _e8558);
let _e10692 = (_e10691 & 31u);
let _e10694 = (1u << bitcast<u32>(_e10692));
let _e10703 = bitcast<i32>((((_e931 + _e10694) - 1u) >> bitcast<u32>(_e10692)));
let _e10704 = bitcast<i32>((((_e934 + _e10694) - 1u) >> bitcast<u32>(_e10692)));
if _e453 {
phi_25918_ = type_23(_e10704, _e10703);
} else {
phi_25918_ = type_23(_e10703, _e10704);
}
let _e10708 = phi_25918_;
let _e10713 = f32((1i << bitcast<u32>(_e10692)));
let _e10714 = (1f / _e10713);
let _e10716 = ((_e9735 * _e10714) - 0.5f);
let _e10718 = ((_e9829 * _e10714) - 0.5f);
let _e10720 = select(-1f, _e10716, (_e10716 > -1f));
let _e10722 = select(1e6f, _e10720, (_e10720 < 1e6f));
let _e10729 = select(0i, select(select(i32(_e10722), i32(-2147483648), (_e10722 < -2147483600f)), 2147483647i, (_e10722 > 2147483500f)), (_e10722 == _e10722));
let _e10733 = (_e10729 - select(0i, 1i, (_e10722 < f32(_e10729))));
let _e10735 = select(-1f, _e10718, (_e10718 > -1f));
let _e10737 = select(1e6f, _e10735, (_e10735 < 1e6f));
let _e10744 = select(0i, select(select(i32(_e10737), i32(-2147483648), (_e10737 < -2147483600f)), 2147483647i, (_e10737 > 2147483500f)), (_e10737 == _e10737));
let _e10748 = (_e10744 - select(0i, 1i, (_e10737 < f32(_e10744))));
let _e10750 = (_e10716 - f32(_e10733));
let _e10752 = (_e10718 - f32(_e10748));
let _e10753 = (1f - _e10750);
let _e10754 = (1f - _e10752);
let _e10757 = select(_e10733, 0i, (_e10733 < 0i));
let _e10758 = (_e10757 >= _e10708.member);
if _e10758 {
phi_25996_ = (_e10708.member - 1i);
} else {
phi_25996_ = _e10757;
}
let _e10761 = phi_25996_;
let _e10763 = select(_e10748, 0i, (_e10748 < 0i));
let _e10764 = (_e10763 >= _e10708.member_1);
if _e10764 {
phi_26007_ = (_e10708.member_1 - 1i);
} else {
phi_26007_ = _e10763;
}
let _e10767 = phi_26007_;
let _e10771 = (((f32(_e10761) + 0.5f) * _e10713) - 0.5f);
let _e10775 = (((f32(_e10767) + 0.5f) * _e10713) - 0.5f);
if _e453 {
phi_26035_ = type_23(_e10767, _e10761);
} else {
phi_26035_ = type_23(_e10761, _e10767);
}
let _e10781 = phi_26035_;
let _e10787 = bitcast<i32>(((_e931 + 1u) >> bitcast<u32>(1u)));
let _e10790 = global_1.member.member_18.member_6;
let _e10793 = global_1.member.member_18.member_7;
let _e10796 = global_1.member.member_18.member_8;
let _e10797 = (_e10691 == 0u);
if _e10797 {
phi_26086_ = 0u;
} else {
if (_e10691 == 1u) {
phi_26085_ = 0u;
} else {
if (_e10691 == 2u) {
phi_26084_ = _e10790;
} else {
phi_26084_ = select(_e10796, _e10793, (_e10691 == 3u));
}
let _e10803 = phi_26084_;
phi_26085_ = _e10803;
}
let _e10805 = phi_26085_;
phi_26086_ = _e10805;
}
let _e10807 = phi_26086_;
local_120 = (((bitcast<i32>(_e10807) + _e10781.member_1) * _e10787) + _e10781.member);
let _e10812 = local_120;
let _e10814 = (bitcast<i32>(_e262) - 1i);
let _e10816 = select(_e10814, _e10812, (_e10812 < _e10814));
let _e10821 = global_6.member[bitcast<u32>(select(0i, _e10816, (_e10816 > 0i)))];
let _e10826 = (((((select(_e10771, _e10775, _e453) + 0.5f) / _e9921) * 2f) - 1f) * _e9929);
let _e10831 = ((1f - (((select(_e10775, _e10771, _e453) + 0.5f) / _e9922) * 2f)) * _e9937);
let _e10838 = ((_e9940.member * _e10826) + (_e9948.member * _e10831));
let _e10839 = ((_e9940.member_1 * _e10826) + (_e9948.member_1 * _e10831));
let _e10840 = ((_e9940.member_2 * _e10826) + (_e9948.member_2 * _e10831));
let _e10844 = select((_e9963.member + _e10838), _e9963.member, _e9961);
let _e10845 = select((_e9963.member_1 + _e10839), _e9963.member_1, _e9961);
let _e10846 = select((_e9963.member_2 + _e10840), _e9963.member_2, _e9961);
let _e10857 = (((_e10844 * _e10844) + (_e10845 * _e10845)) + (_e10846 * _e10846));
let _e10861 = (1f / sqrt(select(0f, _e10857, (_e10857 > 0f))));
let _e10862 = (_e10844 * _e10861);
let _e10863 = (_e10845 * _e10861);
let _e10864 = (_e10846 * _e10861);
let _e10865 = (_e575 - select(_e9974.member, (_e9974.member + _e10838), _e9961));
let _e10866 = (_e587 - select(_e9974.member_1, (_e9974.member_1 + _e10839), _e9961));
let _e10867 = (_e600 - select(_e9974.member_2, (_e9974.member_2 + _e10840), _e9961));
let _e10872 = (((_e10865 * _e10862) + (_e10866 * _e10863)) + (_e10867 * _e10864));
let _e10877 = (((_e10865 * _e613) + (_e10866 * _e626)) + (_e10867 * _e639));
let _e10882 = (((_e10862 * _e613) + (_e10863 * _e626)) + (_e10864 * _e639));
let _e10885 = ((_e10863 * _e639) - (_e10864 * _e626));
let _e10888 = ((_e10864 * _e613) - (_e10862 * _e639));
let _e10891 = ((_e10862 * _e626) - (_e10863 * _e613));
let _e10896 = (((_e10885 * _e10885) + (_e10888 * _e10888)) + (_e10891 * _e10891));
let _e10899 = (1f / select(1e-9f, _e10896, (_e10896 > 1e-9f)));
let _e10902 = ((_e10872 - (_e10882 * _e10877)) * _e10899);
let _e10905 = (((_e10882 * _e10872) - _e10877) * _e10899);
let _e10911 = select(0f, _e10902, (((_e10905 >= 0f) && (_e10905 < _e691)) && (_e10902 > 0f)));
let _e10913 = (_e10761 << bitcast<u32>(_e10692));
let _e10925 = (_e10733 + 1i);
let _e10928 = select(_e10925, 0i, (_e10925 < 0i));
let _e10929 = (_e10928 >= _e10708.member);
if _e10929 {
phi_26747_ = (_e10708.member - 1i);
} else {
phi_26747_ = _e10928;
}
let _e10932 = phi_26747_;
if _e10764 {
phi_26758_ = (_e10708.member_1 - 1i);
} else {
phi_26758_ = _e10763;
}
let _e10935 = phi_26758_;
let _e10939 = (((f32(_e10932) + 0.5f) * _e10713) - 0.5f);
let _e10943 = (((f32(_e10935) + 0.5f) * _e10713) - 0.5f);
if _e453 {
phi_26786_ = type_23(_e10935, _e10932);
} else {
phi_26786_ = type_23(_e10932, _e10935);
}
let _e10949 = phi_26786_;
if _e10797 {
phi_26837_ = 0u;
} else {
if (_e10691 == 1u) {
phi_26836_ = 0u;
} else {
if (_e10691 == 2u) {
phi_26835_ = _e10790;
} else {
phi_26835_ = select(_e10796, _e10793, (_e10691 == 3u));
}
let _e10957 = phi_26835_;
phi_26836_ = _e10957;
}
let _e10959 = phi_26836_;
phi_26837_ = _e10959;
}
let _e10961 = phi_26837_;
local_118 = (((bitcast<i32>(_e10961) + _e10949.member_1) * _e10787) + _e10949.member);
let _e10966 = local_118;
let _e10968 = select(_e10814, _e10966, (_e10966 < _e10814));
let _e10973 = global_6.member[bitcast<u32>(select(0i, _e10968, (_e10968 > 0i)))];
let _e10978 = (((((select(_e10939, _e10943, _e453) + 0.5f) / _e9921) * 2f) - 1f) * _e9929);
let _e10983 = ((1f - (((select(_e10943, _e10939, _e453) + 0.5f) / _e9922) * 2f)) * _e9937);
let _e10990 = ((_e9940.member * _e10978) + (_e9948.member * _e10983));
let _e10991 = ((_e9940.member_1 * _e10978) + (_e9948.member_1 * _e10983));
let _e10992 = ((_e9940.member_2 * _e10978) + (_e9948.member_2 * _e10983));
let _e10996 = select((_e9963.member + _e10990), _e9963.member, _e9961);
let _e10997 = select((_e9963.member_1 + _e10991), _e9963.member_1, _e9961);
let _e10998 = select((_e9963.member_2 + _e10992), _e9963.member_2, _e9961);
let _e11009 = (((_e10996 * _e10996) + (_e10997 * _e10997)) + (_e10998 * _e10998));
let _e11013 = (1f / sqrt(select(0f, _e11009, (_e11009 > 0f))));
let _e11014 = (_e10996 * _e11013);
let _e11015 = (_e10997 * _e11013);
let _e11016 = (_e10998 * _e11013);
let _e11017 = (_e575 - select(_e9974.member, (_e9974.member + _e10990), _e9961));
let _e11018 = (_e587 - select(_e9974.member_1, (_e9974.member_1 + _e10991), _e9961));
let _e11019 = (_e600 - select(_e9974.member_2, (_e9974.member_2 + _e10992), _e9961));
let _e11024 = (((_e11017 * _e11014) + (_e11018 * _e11015)) + (_e11019 * _e11016));
let _e11029 = (((_e11017 * _e613) + (_e11018 * _e626)) + (_e11019 * _e639));
let _e11034 = (((_e11014 * _e613) + (_e11015 * _e626)) + (_e11016 * _e639));
let _e11037 = ((_e11015 * _e639) - (_e11016 * _e626));
let _e11040 = ((_e11016 * _e613) - (_e11014 * _e639));
let _e11043 = ((_e11014 * _e626) - (_e11015 * _e613));
let _e11048 = (((_e11037 * _e11037) + (_e11040 * _e11040)) + (_e11043 * _e11043));
let _e11051 = (1f / select(1e-9f, _e11048, (_e11048 > 1e-9f)));
let _e11054 = ((_e11024 - (_e11034 * _e11029)) * _e11051);
let _e11057 = (((_e11034 * _e11024) - _e11029) * _e11051);
let _e11063 = select(0f, _e11054, (((_e11057 >= 0f) && (_e11057 < _e691)) && (_e11054 > 0f)));
let _e11065 = (_e10932 << bitcast<u32>(_e10692));
let _e11077 = (_e10748 + 1i);
if _e10758 {
phi_27498_ = (_e10708.member - 1i);
} else {
phi_27498_ = _e10757;
}
let _e11081 = phi_27498_;
let _e11083 = select(_e11077, 0i, (_e11077 < 0i));
let _e11084 = (_e11083 >= _e10708.member_1);
if _e11084 {
phi_27509_ = (_e10708.member_1 - 1i);
} else {
phi_27509_ = _e11083;
}
let _e11087 = phi_27509_;
let _e11091 = (((f32(_e11081) + 0.5f) * _e10713) - 0.5f);
let _e11095 = (((f32(_e11087) + 0.5f) * _e10713) - 0.5f);
if _e453 {
phi_27537_ = type_23(_e11087, _e11081);
} else {
phi_27537_ = type_23(_e11081, _e11087);
}
let _e11101 = phi_27537_;
if _e10797 {
phi_27588_ = 0u;
} else {
if (_e10691 == 1u) {
phi_27587_ = 0u;
} else {
if (_e10691 == 2u) {
phi_27586_ = _e10790;
} else {
phi_27586_ = select(_e10796, _e10793, (_e10691 == 3u));
}
let _e11109 = phi_27586_;
phi_27587_ = _e11109;
}
let _e11111 = phi_27587_;
phi_27588_ = _e11111;
}
let _e11113 = phi_27588_;
local_116 = (((bitcast<i32>(_e11113) + _e11101.member_1) * _e10787) + _e11101.member);
let _e11118 = local_116;
let _e11120 = select(_e10814, _e11118, (_e11118 < _e10814));
let _e11125 = global_6.member[bitcast<u32>(select(0i, _e11120, (_e11120 > 0i)))];
let _e11130 = (((((select(_e11091, _e11095, _e453) + 0.5f) / _e9921) * 2f) - 1f) * _e9929);
let _e11135 = ((1f - (((select(_e11095, _e11091, _e453) + 0.5f) / _e9922) * 2f)) * _e9937);
let _e11142 = ((_e9940.member * _e11130) + (_e9948.member * _e11135));
let _e11143 = ((_e9940.member_1 * _e11130) + (_e9948.member_1 * _e11135));
let _e11144 = ((_e9940.member_2 * _e11130) + (_e9948.member_2 * _e11135));
let _e11148 = select((_e9963.member + _e11142), _e9963.member, _e9961);
let _e11149 = select((_e9963.member_1 + _e11143), _e9963.member_1, _e9961);
let _e11150 = select((_e9963.member_2 + _e11144), _e9963.member_2, _e9961);
let _e11161 = (((_e11148 * _e11148) + (_e11149 * _e11149)) + (_e11150 * _e11150));
let _e11165 = (1f / sqrt(select(0f, _e11161, (_e11161 > 0f))));
let _e11166 = (_e11148 * _e11165);
let _e11167 = (_e11149 * _e11165);
let _e11168 = (_e11150 * _e11165);
let _e11169 = (_e575 - select(_e9974.member, (_e9974.member + _e11142), _e9961));
let _e11170 = (_e587 - select(_e9974.member_1, (_e9974.member_1 + _e11143), _e9961));
let _e11171 = (_e600 - select(_e9974.member_2, (_e9974.member_2 + _e11144), _e9961));
let _e11176 = (((_e11169 * _e11166) + (_e11170 * _e11167)) + (_e11171 * _e11168));
let _e11181 = (((_e11169 * _e613) + (_e11170 * _e626)) + (_e11171 * _e639));
let _e11186 = (((_e11166 * _e613) + (_e11167 * _e626)) + (_e11168 * _e639));
let _e11189 = ((_e11167 * _e639) - (_e11168 * _e626));
let _e11192 = ((_e11168 * _e613) - (_e11166 * _e639));
let _e11195 = ((_e11166 * _e626) - (_e11167 * _e613));
let _e11200 = (((_e11189 * _e11189) + (_e11192 * _e11192)) + (_e11195 * _e11195));
let _e11203 = (1f / select(1e-9f, _e11200, (_e11200 > 1e-9f)));
let _e11206 = ((_e11176 - (_e11186 * _e11181)) * _e11203);
let _e11209 = (((_e11186 * _e11176) - _e11181) * _e11203);
let _e11215 = select(0f, _e11206, (((_e11209 >= 0f) && (_e11209 < _e691)) && (_e11206 > 0f)));
let _e11217 = (_e11081 << bitcast<u32>(_e10692));
if _e10929 {
phi_28249_ = (_e10708.member - 1i);
} else {
phi_28249_ = _e10928;
}
let _e11232 = phi_28249_;
if _e11084 {
phi_28260_ = (_e10708.member_1 - 1i);
} else {
phi_28260_ = _e11083;
}
let _e11235 = phi_28260_;
let _e11239 = (((f32(_e11232) + 0.5f) * _e10713) - 0.5f);
let _e11243 = (((f32(_e11235) + 0.5f) * _e10713) - 0.5f);
if _e453 {
phi_28288_ = type_23(_e11235, _e11232);
} else {
phi_28288_ = type_23(_e11232, _e11235);
}
let _e11249 = phi_28288_;
if _e10797 {
phi_28339_ = 0u;
} else {
if (_e10691 == 1u) {
phi_28338_ = 0u;
} else {
if (_e10691 == 2u) {
phi_28337_ = _e10790;
} else {
phi_28337_ = select(_e10796, _e10793, (_e10691 == 3u));
}
let _e11257 = phi_28337_;
phi_28338_ = _e11257;
}
let _e11259 = phi_28338_;
phi_28339_ = _e11259;
}
let _e11261 = phi_28339_;
local_114 = (((bitcast<i32>(_e11261) + _e11249.member_1) * _e10787) + _e11249.member);
let _e11266 = local_114;
let _e11268 = select(_e10814, _e11266, (_e11266 < _e10814));
let _e11273 = global_6.member[bitcast<u32>(select(0i, _e11268, (_e11268 > 0i)))];
let _e11278 = (((((select(_e11239, _e11243, _e453) + 0.5f) / _e9921) * 2f) - 1f) * _e9929);
let _e11283 = ((1f - (((select(_e11243, _e11239, _e453) + 0.5f) / _e9922) * 2f)) * _e9937);
let _e11290 = ((_e9940.member * _e11278) + (_e9948.member * _e11283));
let _e11291 = ((_e9940.member_1 * _e11278) + (_e9948.member_1 * _e11283));
let _e11292 = ((_e9940.member_2 * _e11278) + (_e9948.member_2 * _e11283));
let _e11296 = select((_e9963.member + _e11290), _e9963.member, _e9961);
let _e11297 = select((_e9963.member_1 + _e11291), _e9963.member_1, _e9961);
let _e11298 = select((_e9963.member_2 + _e11292), _e9963.member_2, _e9961);
let _e11309 = (((_e11296 * _e11296) + (_e11297 * _e11297)) + (_e11298 * _e11298));
let _e11313 = (1f / sqrt(select(0f, _e11309, (_e11309 > 0f))));
let _e11314 = (_e11296 * _e11313);
let _e11315 = (_e11297 * _e11313);
let _e11316 = (_e11298 * _e11313);
let _e11317 = (_e575 - select(_e9974.member, (_e9974.member + _e11290), _e9961));
let _e11318 = (_e587 - select(_e9974.member_1, (_e9974.member_1 + _e11291), _e9961));
let _e11319 = (_e600 - select(_e9974.member_2, (_e9974.member_2 + _e11292), _e9961));
let _e11324 = (((_e11317 * _e11314) + (_e11318 * _e11315)) + (_e11319 * _e11316));
let _e11329 = (((_e11317 * _e613) + (_e11318 * _e626)) + (_e11319 * _e639));
let _e11334 = (((_e11314 * _e613) + (_e11315 * _e626)) + (_e11316 * _e639));
let _e11337 = ((_e11315 * _e639) - (_e11316 * _e626));
let _e11340 = ((_e11316 * _e613) - (_e11314 * _e639));
let _e11343 = ((_e11314 * _e626) - (_e11315 * _e613));
let _e11348 = (((_e11337 * _e11337) + (_e11340 * _e11340)) + (_e11343 * _e11343));
let _e11351 = (1f / select(1e-9f, _e11348, (_e11348 > 1e-9f)));
let _e11354 = ((_e11324 - (_e11334 * _e11329)) * _e11351);
let _e11357 = (((_e11334 * _e11324) - _e11329) * _e11351);
let _e11363 = select(0f, _e11354, (((_e11357 >= 0f) && (_e11357 < _e691)) && (_e11354 > 0f)));
let _e11365 = (_e11232 << bitcast<u32>(_e10692));
let _e11377 = select(((((1f - select(0f, (_e10753 * _e10754), (((select(select(_e766, _e927, (_e10913 >= _e692)), _e847, (_e10913 < _e298)) == _e10691) && (_e10911 > 0f)) && (_e10911 < _e10821)))) - select(0f, (_e10750 * _e10754), (((select(select(_e766, _e927, (_e11065 >= _e692)), _e847, (_e11065 < _e298)) == _e10691) && (_e11063 > 0f)) && (_e11063 < _e10973)))) - select(0f, (_e10753 * _e10752), (((select(select(_e766, _e927, (_e11217 >= _e692)), _e847, (_e11217 < _e298)) == _e10691) && (_e11215 > 0f)) && (_e11215 < _e11125)))) - select(0f, (_e10750 * _e10752), (((select(select(_e766, _e927, (_e11365 >= _e692)), _e847, (_e11365 < _e298)) == _e10691) && (_e11363 > 0f)) && (_e11363 < _e11273)))), 1f, _e10797);
if _e453 {
phi_29009_ = type_23(_e9826, _e9733);
} else {
phi_29009_ = type_23(_e9733, _e9826);
}
let _e11392 = phi_29009_;
let _e11395 = (_e9827 && (((_e10689 > 0f) && (_e10689 < _e9917)) && (bitcast<f32>((bitcast<u32>(_e11377) & 2147483647u)) > 1e-6f)));
let _e11398 = global_1.member.member_18.member;
let _e11399 = (((select(_e9852, (1f - _e9852), (_e9837 >= 0f)) - select(_e9871, (1f - _e9871), (_e9856 >= 0f))) * (1f / _e9834)) * _e11398);
let _e11403 = select(0f, (((((_e652 * _e10526.member) * ((1f + (_e10566 * (1f + (_e10566 * (0.5f + (_e10566 * (0.16666667f + (_e10566 * (0.041666668f + (_e10566 * (0.008333334f + (_e10566 * (0.001388889f + (_e10566 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10561 + 127i)) << bitcast<u32>(23i))))) * _e10523) * _e11377) * _e11399), _e11395);
let _e11404 = select(0f, (((((_e665 * _e10526.member_1) * ((1f + (_e10614 * (1f + (_e10614 * (0.5f + (_e10614 * (0.16666667f + (_e10614 * (0.041666668f + (_e10614 * (0.008333334f + (_e10614 * (0.001388889f + (_e10614 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10609 + 127i)) << bitcast<u32>(23i))))) * _e10523) * _e11377) * _e11399), _e11395);
let _e11405 = select(0f, (((((_e678 * _e10526.member_2) * ((1f + (_e10662 * (1f + (_e10662 * (0.5f + (_e10662 * (0.16666667f + (_e10662 * (0.041666668f + (_e10662 * (0.008333334f + (_e10662 * (0.001388889f + (_e10662 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10657 + 127i)) << bitcast<u32>(23i))))) * _e10523) * _e11377) * _e11399), _e11395);
let _e11409 = (bitcast<f32>((bitcast<u32>(_e11403) & 2147483647u)) >= 1073741800f);
let _e11410 = (1f / 1048576f);
let _e11413 = ((_e11403 * select(1f, _e11410, _e11409)) + 0.5f);
let _e11415 = select(-1073741800f, _e11413, (_e11413 > -1073741800f));
let _e11417 = select(1073741800f, _e11415, (_e11415 < 1073741800f));
let _e11424 = select(0i, select(select(i32(_e11417), i32(-2147483648), (_e11417 < -2147483600f)), 2147483647i, (_e11417 > 2147483500f)), (_e11417 == _e11417));
let _e11428 = (_e11424 - select(0i, 1i, (_e11417 < f32(_e11424))));
let _e11429 = select(0i, 20i, _e11409);
let _e11433 = (bitcast<u32>(_e11428) << bitcast<u32>((_e11429 & 31i)));
let _e11440 = bitcast<u32>(((_e11428 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11429) & 31i))));
let _e11444 = (bitcast<f32>((bitcast<u32>(_e11404) & 2147483647u)) >= 1073741800f);
let _e11447 = ((_e11404 * select(1f, _e11410, _e11444)) + 0.5f);
let _e11449 = select(-1073741800f, _e11447, (_e11447 > -1073741800f));
let _e11451 = select(1073741800f, _e11449, (_e11449 < 1073741800f));
let _e11458 = select(0i, select(select(i32(_e11451), i32(-2147483648), (_e11451 < -2147483600f)), 2147483647i, (_e11451 > 2147483500f)), (_e11451 == _e11451));
let _e11462 = (_e11458 - select(0i, 1i, (_e11451 < f32(_e11458))));
let _e11463 = select(0i, 20i, _e11444);
let _e11467 = (bitcast<u32>(_e11462) << bitcast<u32>((_e11463 & 31i)));
let _e11474 = bitcast<u32>(((_e11462 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11463) & 31i))));
let _e11478 = (bitcast<f32>((bitcast<u32>(_e11405) & 2147483647u)) >= 1073741800f);
let _e11481 = ((_e11405 * select(1f, _e11410, _e11478)) + 0.5f);
let _e11483 = select(-1073741800f, _e11481, (_e11481 > -1073741800f));
let _e11485 = select(1073741800f, _e11483, (_e11483 < 1073741800f));
let _e11492 = select(0i, select(select(i32(_e11485), i32(-2147483648), (_e11485 < -2147483600f)), 2147483647i, (_e11485 > 2147483500f)), (_e11485 == _e11485));
let _e11496 = (_e11492 - select(0i, 1i, (_e11485 < f32(_e11492))));
let _e11497 = select(0i, 20i, _e11478);
let _e11501 = (bitcast<u32>(_e11496) << bitcast<u32>((_e11497 & 31i)));
let _e11508 = bitcast<u32>(((_e11496 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11497) & 31i))));
let _e11513 = bitcast<i32>(bitcast<u32>((((_e11392.member_1 * _e935) + _e11392.member) * 6i)));
if ((_e11433 | _e11440) == 0u) {
} else {
let _e11516 = bitcast<u32>(_e11513);
if (_e11516 < _e270) {
let _e11520 = atomicAdd((&global_8.member[_e11516]), _e11433);
phi_29242_ = _e11520;
} else {
phi_29242_ = 0u;
}
let _e11522 = phi_29242_;
let _e11526 = (_e11440 + select(0u, 1u, ((_e11522 + _e11433) < _e11433)));
if (_e11526 == 0u) {
} else {
let _e11528 = (_e11516 + 1u);
if (_e11528 < _e270) {
let _e11532 = atomicAdd((&global_8.member[_e11528]), _e11526);
}
}
}
if ((_e11467 | _e11474) == 0u) {
} else {
let _e11536 = bitcast<u32>((_e11513 + 2i));
if (_e11536 < _e270) {
let _e11540 = atomicAdd((&global_8.member[_e11536]), _e11467);
phi_29272_ = _e11540;
} else {
phi_29272_ = 0u;
}
let _e11542 = phi_29272_;
let _e11546 = (_e11474 + select(0u, 1u, ((_e11542 + _e11467) < _e11467)));
if (_e11546 == 0u) {
} else {
let _e11548 = (_e11536 + 1u);
if (_e11548 < _e270) {
let _e11552 = atomicAdd((&global_8.member[_e11548]), _e11546);
}
}
}
if ((_e11501 | _e11508) == 0u) {
} else {
let _e11556 = bitcast<u32>((_e11513 + 4i));
if (_e11556 < _e270) {
let _e11560 = atomicAdd((&global_8.member[_e11556]), _e11501);
phi_29302_ = _e11560;
} else {
phi_29302_ = 0u;
}
let _e11562 = phi_29302_;
let _e11566 = (_e11508 + select(0u, 1u, ((_e11562 + _e11501) < _e11501)));
if (_e11566 == 0u) {
} else {
let _e11568 = (_e11556 + 1u);
if (_e11568 < _e270) {
let _e11572 = atomicAdd((&global_8.member[_e11568]), _e11566);
}
}
}
phi_24518_ = (_e9824 + 1i);
} else {
phi_24518_ = i32();
}
let _e11575 = phi_24518_;
continue;
continuing {
phi_24517_ = _e11575;
break if !(_e9827);
}
}
phi_24364_ = (_e9730 + 1i);
} else {
phi_24364_ = i32();
}
let _e11579 = phi_24364_;
continue;
continuing {
phi_24363_ = _e11579;
break if !(_e9731);
}
}
} else {
phi_29347_ = 0i;
loop {
let _e11582 = phi_29347_;
let _e11583 = (_e11582 < 16i);
if _e11583 {
let _e11585 = (_e980 + (_e11582 & 15i));
let _e11587 = (f32(_e11585) + 0.5f);
let _e11589 = ((_e11587 * 1f) - 0.5f);
let _e11593 = (-(((_e416 * _e11589) + _e442)) / _e429);
let _e11600 = bitcast<f32>((bitcast<u32>(((_e466 * _e11589) + ((_e479 * _e11593) + _e492))) & 2147483647u));
let _e11607 = bitcast<f32>((bitcast<u32>(((_e505 * _e11589) + ((_e518 * _e11593) + _e531))) & 2147483647u));
let _e11611 = (((0.5f * (_e11600 + _e11607)) / _e534) + _e717);
let _e11612 = (1f / 1f);
let _e11620 = ((((_e11593 + _e11611) + 0.5f) * _e11612) - 0.5f);
let _e11621 = f32(_e8552);
let _e11622 = f32(_e8550);
let _e11623 = (_e11621 - 1f);
let _e11625 = select(_e11623, _e11620, (_e11620 > _e11623));
let _e11627 = select(_e11622, _e11625, (_e11625 < _e11622));
let _e11634 = select(0i, select(select(i32(_e11627), i32(-2147483648), (_e11627 < -2147483600f)), 2147483647i, (_e11627 > 2147483500f)), (_e11627 == _e11627));
let _e11639 = (((((_e11593 - _e11611) + 0.5f) * _e11612) - 0.5f) + 1f);
let _e11640 = (_e11622 + 1f);
let _e11642 = select(_e11621, _e11639, (_e11639 > _e11621));
let _e11644 = select(_e11640, _e11642, (_e11642 < _e11640));
let _e11651 = select(0i, select(select(i32(_e11644), i32(-2147483648), (_e11644 < -2147483600f)), 2147483647i, (_e11644 > 2147483500f)), (_e11644 == _e11644));
let _e11662 = ((1e-4f * 1f) * _e534);
let _e11664 = select(_e11607, _e11600, (_e11600 > _e11607));
let _e11666 = select(_e11662, _e11664, (_e11664 > _e11662));
let _e11668 = select(_e11607, _e11600, (_e11600 < _e11607));
let _e11670 = select(_e11662, _e11668, (_e11668 > _e11662));
let _e11672 = (0.5f * (_e11666 + _e11670));
let _e11673 = (0.5f / _e11670);
let _e11674 = (1f / _e11666);
phi_29501_ = 0i;
loop {
let _e11676 = phi_29501_;
let _e11678 = (((_e11651 - select(0i, 1i, (_e11644 < f32(_e11651)))) + (_e11582 >> bitcast<u32>(4u))) + bitcast<i32>(_e11676));
let _e11679 = (_e11678 <= select(-1i, (_e11634 - select(0i, 1i, (_e11627 < f32(_e11634)))), (_e11585 <= _e984)));
if _e11679 {
let _e11681 = (f32(_e11678) + 0.5f);
let _e11685 = ((((_e11681 * 1f) - 0.5f) - _e11593) * _e534);
let _e11686 = (_e534 * 1f);
let _e11688 = (0.5f * _e11686);
let _e11689 = (_e11685 + _e11688);
let _e11690 = -(_e11689);
let _e11693 = (_e11672 - select(_e11690, _e11689, (_e11689 > _e11690)));
let _e11695 = select(0f, _e11693, (_e11693 > 0f));
let _e11697 = select(_e11670, _e11695, (_e11695 < _e11670));
let _e11700 = (_e11693 - _e11670);
let _e11704 = (((_e11697 * (_e11697 * _e11673)) + select(0f, _e11700, (_e11700 > 0f))) * _e11674);
let _e11708 = (_e11685 - _e11688);
let _e11709 = -(_e11708);
let _e11712 = (_e11672 - select(_e11709, _e11708, (_e11708 > _e11709)));
let _e11714 = select(0f, _e11712, (_e11712 > 0f));
let _e11716 = select(_e11670, _e11714, (_e11714 < _e11670));
let _e11719 = (_e11712 - _e11670);
let _e11723 = (((_e11716 * (_e11716 * _e11673)) + select(0f, _e11719, (_e11719 > 0f))) * _e11674);
if _e453 {
phi_29606_ = type_23(_e11678, _e11585);
} else {
phi_29606_ = type_23(_e11585, _e11678);
}
let _e11732 = phi_29606_;
let _e11736 = bitcast<i32>((_e931 * _e934));
local_112 = _e11736;
local_113 = ((_e11732.member_1 * _e935) + _e11732.member);
let _e11739 = local_112;
let _e11740 = local_113;
let _e11741 = (_e11739 + _e11740);
let _e11743 = (bitcast<i32>(_e259) - 1i);
let _e11745 = select(_e11743, _e11741, (_e11741 < _e11743));
let _e11750 = global_5.member[bitcast<u32>(select(0i, _e11745, (_e11745 > 0i)))];
let _e11751 = local_112;
let _e11753 = local_113;
let _e11754 = ((2i * _e11751) + _e11753);
let _e11756 = select(_e11743, _e11754, (_e11754 < _e11743));
let _e11761 = global_5.member[bitcast<u32>(select(0i, _e11756, (_e11756 > 0i)))];
let _e11762 = local_113;
let _e11764 = select(_e11743, _e11762, (_e11762 < _e11743));
let _e11769 = global_5.member[bitcast<u32>(select(0i, _e11764, (_e11764 > 0i)))];
let _e11770 = local_113;
let _e11773 = f32(_e935);
let _e11774 = f32(_e936);
let _e11781 = global_1.member.member_2.member;
let _e11782 = (((((f32(_e11732.member) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e11789 = global_1.member.member_2.member_1;
let _e11790 = ((1f - (((f32(_e11732.member_1) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e11792 = global_1.member.member_3;
let _e11800 = global_1.member.member_4;
let _e11807 = ((_e11792.member * _e11782) + (_e11800.member * _e11790));
let _e11808 = ((_e11792.member_1 * _e11782) + (_e11800.member_1 * _e11790));
let _e11809 = ((_e11792.member_2 * _e11782) + (_e11800.member_2 * _e11790));
let _e11812 = global_1.member.member_2.member_3;
let _e11813 = (_e11812 != 0u);
let _e11815 = global_1.member.member_5;
let _e11822 = select((_e11815.member + _e11807), _e11815.member, _e11813);
let _e11823 = select((_e11815.member_1 + _e11808), _e11815.member_1, _e11813);
let _e11824 = select((_e11815.member_2 + _e11809), _e11815.member_2, _e11813);
let _e11826 = global_1.member.member_6;
let _e11833 = select(_e11826.member, (_e11826.member + _e11807), _e11813);
let _e11834 = select(_e11826.member_1, (_e11826.member_1 + _e11808), _e11813);
let _e11835 = select(_e11826.member_2, (_e11826.member_2 + _e11809), _e11813);
let _e11840 = (((_e11822 * _e11822) + (_e11823 * _e11823)) + (_e11824 * _e11824));
let _e11843 = sqrt(select(0f, _e11840, (_e11840 > 0f)));
let _e11844 = (1f / _e11843);
let _e11845 = (_e11822 * _e11844);
let _e11846 = (_e11823 * _e11844);
let _e11847 = (_e11824 * _e11844);
let _e11848 = (_e575 - _e11833);
let _e11849 = (_e587 - _e11834);
let _e11850 = (_e600 - _e11835);
let _e11855 = (((_e11848 * _e11845) + (_e11849 * _e11846)) + (_e11850 * _e11847));
let _e11860 = (((_e11848 * _e613) + (_e11849 * _e626)) + (_e11850 * _e639));
let _e11865 = (((_e11845 * _e613) + (_e11846 * _e626)) + (_e11847 * _e639));
let _e11868 = ((_e11846 * _e639) - (_e11847 * _e626));
let _e11871 = ((_e11847 * _e613) - (_e11845 * _e639));
let _e11874 = ((_e11845 * _e626) - (_e11846 * _e613));
let _e11879 = (((_e11868 * _e11868) + (_e11871 * _e11871)) + (_e11874 * _e11874));
let _e11882 = (1f / select(1e-9f, _e11879, (_e11879 > 1e-9f)));
let _e11885 = ((_e11855 - (_e11865 * _e11860)) * _e11882);
let _e11888 = (((_e11865 * _e11855) - _e11860) * _e11882);
let _e11894 = -(_e11865);
let _e11897 = global_1.member.member_13.member_2;
let _e11898 = (_e11897 * _e11897);
let _e11902 = ((1f + _e11898) - ((2f * _e11897) * _e11894));
let _e11904 = select(1e-9f, _e11902, (_e11902 > 1e-9f));
let _e11916 = global_1.member.member_13.member_3;
if (_e11916 == 2u) {
let _e11921 = (0.5f - (0.5f * _e11894));
let _e11923 = select(0f, _e11921, (_e11921 > 0f));
let _e11927 = (sqrt(select(0f, _e11923, (_e11923 > 0f))) * 255f);
let _e11928 = (255f - 1f);
let _e11930 = select(0f, _e11927, (_e11927 > 0f));
let _e11932 = select(_e11928, _e11930, (_e11930 < _e11928));
let _e11939 = select(0i, select(select(i32(_e11932), i32(-2147483648), (_e11932 < -2147483600f)), 2147483647i, (_e11932 > 2147483500f)), (_e11932 == _e11932));
let _e11943 = (_e11939 - select(0i, 1i, (_e11932 < f32(_e11939))));
let _e11946 = global_1.member.member_13.member_11;
let _e11947 = bitcast<i32>(_e11946);
let _e11948 = (_e11947 + _e11943);
let _e11950 = (bitcast<i32>(_e265) - 1i);
let _e11952 = select(_e11950, _e11948, (_e11948 < _e11950));
let _e11957 = global_2.member[bitcast<u32>(select(0i, _e11952, (_e11952 > 0i)))];
let _e11959 = (_e11947 + (_e11943 + 1i));
let _e11961 = select(_e11950, _e11959, (_e11959 < _e11950));
let _e11966 = global_2.member[bitcast<u32>(select(0i, _e11961, (_e11961 > 0i)))];
phi_30033_ = (_e11957 + ((_e11966 - _e11957) * (_e11927 - f32(_e11943))));
} else {
phi_30033_ = select(((1f - _e11898) / (_e11904 * sqrt(select(0f, _e11904, (_e11904 > 0f))))), (0.75f * (1f + (_e11894 * _e11894))), (_e11916 == 1u));
}
let _e11973 = phi_30033_;
let _e11979 = global_1.member.member_12.member_11;
let _e11982 = global_1.member.member_12.member_4;
let _e11985 = global_1.member.member_12.member_12;
let _e11991 = global_1.member.member.member;
let _e11993 = (_e11888 / _e691);
local_109 = bitcast<i32>((_e11979 + (_e11982 * _e11985)));
local_110 = _e281;
local_111 = bitcast<i32>(_e11991);
let _e11996 = global_1.member.member_13.member_6;
let _e11997 = f32(_e11996);
let _e11999 = select(0f, _e11993, (_e11993 > 0f));
let _e12002 = (select(1f, _e11999, (_e11999 < 1f)) * _e11997);
let _e12003 = (_e11997 - 1f);
let _e12005 = select(0f, _e12003, (_e12003 > 0f));
let _e12007 = select(0f, _e12002, (_e12002 > 0f));
let _e12009 = select(_e12005, _e12007, (_e12007 < _e12005));
let _e12016 = select(0i, select(select(i32(_e12009), i32(-2147483648), (_e12009 < -2147483600f)), 2147483647i, (_e12009 > 2147483500f)), (_e12009 == _e12009));
let _e12020 = (_e12016 - select(0i, 1i, (_e12009 < f32(_e12016))));
if (_e12020 > 0i) {
let _e12023 = local_109;
let _e12024 = local_111;
let _e12027 = local_110;
let _e12028 = ((_e12023 + ((_e12020 - 1i) * _e12024)) + _e12027);
let _e12030 = (bitcast<i32>(_e268) - 1i);
let _e12032 = select(_e12030, _e12028, (_e12028 < _e12030));
let _e12037 = global_7.member[bitcast<u32>(select(0i, _e12032, (_e12032 > 0i)))];
phi_30139_ = _e12037;
} else {
phi_30139_ = 0f;
}
let _e12039 = phi_30139_;
let _e12040 = local_109;
let _e12041 = local_111;
let _e12044 = local_110;
let _e12045 = ((_e12040 + (_e12020 * _e12041)) + _e12044);
let _e12047 = (bitcast<i32>(_e268) - 1i);
let _e12049 = select(_e12047, _e12045, (_e12045 < _e12047));
let _e12054 = global_7.member[bitcast<u32>(select(0i, _e12049, (_e12049 > 0i)))];
let _e12061 = (_e11761 - _e11750);
let _e12064 = ((_e11885 - _e11750) / select(1e-9f, _e12061, (_e12061 > 1e-9f)));
local_106 = 0i;
local_107 = _e11770;
local_108 = _e11736;
let _e12066 = select(0f, _e12064, (_e12064 > 0f));
let _e12069 = (select(1f, _e12066, (_e12066 < 1f)) * _e11997);
let _e12071 = select(0f, _e12069, (_e12069 > 0f));
let _e12073 = select(_e12005, _e12071, (_e12071 < _e12005));
let _e12080 = select(0i, select(select(i32(_e12073), i32(-2147483648), (_e12073 < -2147483600f)), 2147483647i, (_e12073 > 2147483500f)), (_e12073 == _e12073));
let _e12084 = (_e12080 - select(0i, 1i, (_e12073 < f32(_e12080))));
if (_e12084 > 0i) {
let _e12087 = local_106;
let _e12088 = local_108;
let _e12091 = local_107;
let _e12092 = ((_e12087 + ((_e12084 - 1i) * _e12088)) + _e12091);
let _e12094 = select(_e12047, _e12092, (_e12092 < _e12047));
let _e12099 = global_7.member[bitcast<u32>(select(0i, _e12094, (_e12094 > 0i)))];
phi_30266_ = _e12099;
} else {
phi_30266_ = 0f;
}
let _e12101 = phi_30266_;
let _e12102 = local_106;
let _e12103 = local_108;
let _e12106 = local_107;
let _e12107 = ((_e12102 + (_e12084 * _e12103)) + _e12106);
let _e12109 = select(_e12047, _e12107, (_e12107 < _e12047));
let _e12114 = global_7.member[bitcast<u32>(select(0i, _e12109, (_e12109 > 0i)))];
let _e12120 = ((_e12039 + ((_e12054 - _e12039) * (_e12002 - f32(_e12020)))) + (_e12101 + ((_e12114 - _e12101) * (_e12069 - f32(_e12084)))));
let _e12129 = global_1.member.member_13.member_7;
let _e12130 = bitcast<i32>(_e12129);
let _e12133 = global_1.member.member_13.member_8;
let _e12134 = bitcast<i32>(_e12133);
let _e12137 = global_1.member.member_13.member_9;
let _e12138 = bitcast<i32>(_e12137);
let _e12141 = global_1.member.member_13.member_4;
let _e12147 = global_1.member.member_13.member_5;
let _e12151 = f32(_e12130);
let _e12156 = (((((_e11833 + (_e11845 * _e11885)) - _e12141.member) / (_e12147.member - _e12141.member)) * _e12151) - 0.5f);
let _e12157 = (_e12151 - 1f);
let _e12159 = select(0f, _e12156, (_e12156 > 0f));
let _e12161 = select(_e12157, _e12159, (_e12159 < _e12157));
let _e12162 = f32(_e12134);
let _e12167 = (((((_e11834 + (_e11846 * _e11885)) - _e12141.member_1) / (_e12147.member_1 - _e12141.member_1)) * _e12162) - 0.5f);
let _e12168 = (_e12162 - 1f);
let _e12170 = select(0f, _e12167, (_e12167 > 0f));
let _e12172 = select(_e12168, _e12170, (_e12170 < _e12168));
let _e12173 = f32(_e12138);
let _e12178 = (((((_e11835 + (_e11847 * _e11885)) - _e12141.member_2) / (_e12147.member_2 - _e12141.member_2)) * _e12173) - 0.5f);
let _e12179 = (_e12173 - 1f);
let _e12181 = select(0f, _e12178, (_e12178 > 0f));
let _e12183 = select(_e12179, _e12181, (_e12181 < _e12179));
let _e12185 = select(0f, _e12161, (_e12161 > 0f));
let _e12187 = select(1e6f, _e12185, (_e12185 < 1e6f));
let _e12194 = select(0i, select(select(i32(_e12187), i32(-2147483648), (_e12187 < -2147483600f)), 2147483647i, (_e12187 > 2147483500f)), (_e12187 == _e12187));
let _e12198 = (_e12194 - select(0i, 1i, (_e12187 < f32(_e12194))));
let _e12200 = select(0f, _e12172, (_e12172 > 0f));
let _e12202 = select(1e6f, _e12200, (_e12200 < 1e6f));
let _e12209 = select(0i, select(select(i32(_e12202), i32(-2147483648), (_e12202 < -2147483600f)), 2147483647i, (_e12202 > 2147483500f)), (_e12202 == _e12202));
let _e12213 = (_e12209 - select(0i, 1i, (_e12202 < f32(_e12209))));
let _e12215 = select(0f, _e12183, (_e12183 > 0f));
let _e12217 = select(1e6f, _e12215, (_e12215 < 1e6f));
let _e12224 = select(0i, select(select(i32(_e12217), i32(-2147483648), (_e12217 < -2147483600f)), 2147483647i, (_e12217 > 2147483500f)), (_e12217 == _e12217));
let _e12228 = (_e12224 - select(0i, 1i, (_e12217 < f32(_e12224))));
let _e12232 = (_e12172 - f32(_e12213));
let _e12234 = (_e12183 - f32(_e12228));
local_104 = (_e12161 - f32(_e12198));
let _e12235 = (_e12198 + 1i);
let _e12237 = select(_e12235, 0i, (_e12235 < 0i));
if (_e12237 >= _e12130) {
phi_30414_ = (_e12130 - 1i);
} else {
phi_30414_ = _e12237;
}
let _e12241 = phi_30414_;
local_105 = (_e12241 - _e12198);
let _e12243 = (_e12213 + 1i);
let _e12245 = select(_e12243, 0i, (_e12243 < 0i));
if (_e12245 >= _e12134) {
phi_30427_ = (_e12134 - 1i);
} else {
phi_30427_ = _e12245;
}
let _e12249 = phi_30427_;
let _e12251 = ((_e12249 - _e12213) * _e12130);
let _e12252 = (_e12228 + 1i);
let _e12254 = select(_e12252, 0i, (_e12252 < 0i));
if (_e12254 >= _e12138) {
phi_30441_ = (_e12138 - 1i);
} else {
phi_30441_ = _e12254;
}
let _e12258 = phi_30441_;
let _e12264 = global_1.member.member_13.member_10;
let _e12270 = ((bitcast<i32>(_e12264) + (((_e12228 * _e12134) + _e12213) * _e12130)) + _e12198);
let _e12272 = (bitcast<i32>(_e265) - 1i);
let _e12274 = select(_e12272, _e12270, (_e12270 < _e12272));
let _e12279 = global_2.member[bitcast<u32>(select(0i, _e12274, (_e12274 > 0i)))];
let _e12280 = local_104;
let _e12283 = local_105;
let _e12284 = (_e12270 + _e12283);
let _e12286 = select(_e12272, _e12284, (_e12284 < _e12272));
let _e12291 = global_2.member[bitcast<u32>(select(0i, _e12286, (_e12286 > 0i)))];
let _e12292 = local_104;
let _e12295 = (1f - _e12232);
let _e12297 = (_e12270 + _e12251);
let _e12299 = select(_e12272, _e12297, (_e12297 < _e12272));
let _e12304 = global_2.member[bitcast<u32>(select(0i, _e12299, (_e12299 > 0i)))];
let _e12305 = local_104;
let _e12308 = local_105;
let _e12309 = (_e12297 + _e12308);
let _e12311 = select(_e12272, _e12309, (_e12309 < _e12272));
let _e12316 = global_2.member[bitcast<u32>(select(0i, _e12311, (_e12311 > 0i)))];
let _e12317 = local_104;
let _e12322 = (_e12270 + (((_e12258 - _e12228) * _e12130) * _e12134));
let _e12324 = select(_e12272, _e12322, (_e12322 < _e12272));
let _e12329 = global_2.member[bitcast<u32>(select(0i, _e12324, (_e12324 > 0i)))];
let _e12330 = local_104;
let _e12333 = local_105;
let _e12334 = (_e12322 + _e12333);
let _e12336 = select(_e12272, _e12334, (_e12334 < _e12272));
let _e12341 = global_2.member[bitcast<u32>(select(0i, _e12336, (_e12336 > 0i)))];
let _e12342 = local_104;
let _e12346 = (_e12322 + _e12251);
let _e12348 = select(_e12272, _e12346, (_e12346 < _e12272));
let _e12353 = global_2.member[bitcast<u32>(select(0i, _e12348, (_e12348 > 0i)))];
let _e12354 = local_104;
let _e12357 = local_105;
let _e12358 = (_e12346 + _e12357);
let _e12360 = select(_e12272, _e12358, (_e12358 < _e12272));
let _e12365 = global_2.member[bitcast<u32>(select(0i, _e12360, (_e12360 > 0i)))];
let _e12366 = local_104;
let _e12375 = ((_e11843 * (_e11973 * (0.25f / 3.1415927f))) * ((((((_e12279 * (1f - _e12280)) + (_e12291 * _e12292)) * _e12295) + (((_e12304 * (1f - _e12305)) + (_e12316 * _e12317)) * _e12232)) * (1f - _e12234)) + (((((_e12329 * (1f - _e12330)) + (_e12341 * _e12342)) * _e12295) + (((_e12353 * (1f - _e12354)) + (_e12365 * _e12366)) * _e12232)) * _e12234)));
let _e12378 = global_1.member.member_13.member_1;
let _e12387 = global_1.member.member_13.member;
let _e12392 = -((_e12387.member * _e12120));
let _e12394 = select(-87f, _e12392, (_e12392 > -87f));
let _e12396 = select(88f, _e12394, (_e12394 < 88f));
let _e12398 = ((_e12396 * 1.442695f) + 0.5f);
let _e12400 = select(-127f, _e12398, (_e12398 > -127f));
let _e12402 = select(128f, _e12400, (_e12400 < 128f));
let _e12409 = select(0i, select(select(i32(_e12402), i32(-2147483648), (_e12402 < -2147483600f)), 2147483647i, (_e12402 > 2147483500f)), (_e12402 == _e12402));
let _e12413 = (_e12409 - select(0i, 1i, (_e12402 < f32(_e12409))));
let _e12414 = f32(_e12413);
let _e12418 = ((_e12396 - (_e12414 * 0.6933594f)) - (_e12414 * -2.1219444e-4f));
let _e12440 = -((_e12387.member_1 * _e12120));
let _e12442 = select(-87f, _e12440, (_e12440 > -87f));
let _e12444 = select(88f, _e12442, (_e12442 < 88f));
let _e12446 = ((_e12444 * 1.442695f) + 0.5f);
let _e12448 = select(-127f, _e12446, (_e12446 > -127f));
let _e12450 = select(128f, _e12448, (_e12448 < 128f));
let _e12457 = select(0i, select(select(i32(_e12450), i32(-2147483648), (_e12450 < -2147483600f)), 2147483647i, (_e12450 > 2147483500f)), (_e12450 == _e12450));
let _e12461 = (_e12457 - select(0i, 1i, (_e12450 < f32(_e12457))));
let _e12462 = f32(_e12461);
let _e12466 = ((_e12444 - (_e12462 * 0.6933594f)) - (_e12462 * -2.1219444e-4f));
let _e12488 = -((_e12387.member_2 * _e12120));
let _e12490 = select(-87f, _e12488, (_e12488 > -87f));
let _e12492 = select(88f, _e12490, (_e12490 < 88f));
let _e12494 = ((_e12492 * 1.442695f) + 0.5f);
let _e12496 = select(-127f, _e12494, (_e12494 > -127f));
let _e12498 = select(128f, _e12496, (_e12496 < 128f));
let _e12505 = select(0i, select(select(i32(_e12498), i32(-2147483648), (_e12498 < -2147483600f)), 2147483647i, (_e12498 > 2147483500f)), (_e12498 == _e12498));
let _e12509 = (_e12505 - select(0i, 1i, (_e12498 < f32(_e12505))));
let _e12510 = f32(_e12509);
let _e12514 = ((_e12492 - (_e12510 * 0.6933594f)) - (_e12510 * -2.1219444e-4f));
let _e12541 = select(0f, _e11885, (((_e11888 >= 0f) && (_e11888 < _e691)) && (_e11885 > 0f)));
if _e453 {
phi_30900_ = type_23(_e7215, _e7214);
} else {
phi_30900_ = type_23(_e7214, _e7215);
}
let _e12545 = phi_30900_;
let _e12550 = f32((1i << bitcast<u32>(_e7203)));
let _e12551 = (1f / _e12550);
let _e12553 = ((_e11587 * _e12551) - 0.5f);
let _e12555 = ((_e11681 * _e12551) - 0.5f);
let _e12557 = select(-1f, _e12553, (_e12553 > -1f));
let _e12559 = select(1e6f, _e12557, (_e12557 < 1e6f));
let _e12566 = select(0i, select(select(i32(_e12559), i32(-2147483648), (_e12559 < -2147483600f)), 2147483647i, (_e12559 > 2147483500f)), (_e12559 == _e12559));
let _e12570 = (_e12566 - select(0i, 1i, (_e12559 < f32(_e12566))));
let _e12572 = select(-1f, _e12555, (_e12555 > -1f));
let _e12574 = select(1e6f, _e12572, (_e12572 < 1e6f));
let _e12581 = select(0i, select(select(i32(_e12574), i32(-2147483648), (_e12574 < -2147483600f)), 2147483647i, (_e12574 > 2147483500f)), (_e12574 == _e12574));
let _e12585 = (_e12581 - select(0i, 1i, (_e12574 < f32(_e12581))));
let _e12587 = (_e12553 - f32(_e12570));
let _e12589 = (_e12555 - f32(_e12585));
let _e12590 = (1f - _e12587);
let _e12591 = (1f - _e12589);
let _e12594 = select(_e12570, 0i, (_e12570 < 0i));
let _e12595 = (_e12594 >= _e12545.member);
if _e12595 {
phi_30978_ = (_e12545.member - 1i);
} else {
phi_30978_ = _e12594;
}
let _e12598 = phi_30978_;
let _e12600 = select(_e12585, 0i, (_e12585 < 0i));
let _e12601 = (_e12600 >= _e12545.member_1);
if _e12601 {
phi_30989_ = (_e12545.member_1 - 1i);
} else {
phi_30989_ = _e12600;
}
let _e12604 = phi_30989_;
let _e12608 = (((f32(_e12598) + 0.5f) * _e12550) - 0.5f);
let _e12612 = (((f32(_e12604) + 0.5f) * _e12550) - 0.5f);
if _e453 {
phi_31017_ = type_23(_e12604, _e12598);
} else {
phi_31017_ = type_23(_e12598, _e12604);
}
let _e12618 = phi_31017_;
let _e12624 = bitcast<i32>(((_e931 + 1u) >> bitcast<u32>(1u)));
let _e12627 = global_1.member.member_18.member_6;
let _e12630 = global_1.member.member_18.member_7;
let _e12633 = global_1.member.member_18.member_8;
if _e986 {
phi_31068_ = 0u;
} else {
if (_e766 == 1u) {
phi_31067_ = 0u;
} else {
if (_e766 == 2u) {
phi_31066_ = _e12627;
} else {
phi_31066_ = select(_e12633, _e12630, (_e766 == 3u));
}
let _e12639 = phi_31066_;
phi_31067_ = _e12639;
}
let _e12641 = phi_31067_;
phi_31068_ = _e12641;
}
let _e12643 = phi_31068_;
local_102 = (((bitcast<i32>(_e12643) + _e12618.member_1) * _e12624) + _e12618.member);
let _e12648 = local_102;
let _e12650 = (bitcast<i32>(_e262) - 1i);
let _e12652 = select(_e12650, _e12648, (_e12648 < _e12650));
let _e12657 = global_6.member[bitcast<u32>(select(0i, _e12652, (_e12652 > 0i)))];
let _e12662 = (((((select(_e12608, _e12612, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e12667 = ((1f - (((select(_e12612, _e12608, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e12674 = ((_e11792.member * _e12662) + (_e11800.member * _e12667));
let _e12675 = ((_e11792.member_1 * _e12662) + (_e11800.member_1 * _e12667));
let _e12676 = ((_e11792.member_2 * _e12662) + (_e11800.member_2 * _e12667));
let _e12680 = select((_e11815.member + _e12674), _e11815.member, _e11813);
let _e12681 = select((_e11815.member_1 + _e12675), _e11815.member_1, _e11813);
let _e12682 = select((_e11815.member_2 + _e12676), _e11815.member_2, _e11813);
let _e12693 = (((_e12680 * _e12680) + (_e12681 * _e12681)) + (_e12682 * _e12682));
let _e12697 = (1f / sqrt(select(0f, _e12693, (_e12693 > 0f))));
let _e12698 = (_e12680 * _e12697);
let _e12699 = (_e12681 * _e12697);
let _e12700 = (_e12682 * _e12697);
let _e12701 = (_e575 - select(_e11826.member, (_e11826.member + _e12674), _e11813));
let _e12702 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e12675), _e11813));
let _e12703 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e12676), _e11813));
let _e12708 = (((_e12701 * _e12698) + (_e12702 * _e12699)) + (_e12703 * _e12700));
let _e12713 = (((_e12701 * _e613) + (_e12702 * _e626)) + (_e12703 * _e639));
let _e12718 = (((_e12698 * _e613) + (_e12699 * _e626)) + (_e12700 * _e639));
let _e12721 = ((_e12699 * _e639) - (_e12700 * _e626));
let _e12724 = ((_e12700 * _e613) - (_e12698 * _e639));
let _e12727 = ((_e12698 * _e626) - (_e12699 * _e613));
let _e12732 = (((_e12721 * _e12721) + (_e12724 * _e12724)) + (_e12727 * _e12727));
let _e12735 = (1f / select(1e-9f, _e12732, (_e12732 > 1e-9f)));
let _e12738 = ((_e12708 - (_e12718 * _e12713)) * _e12735);
let _e12741 = (((_e12718 * _e12708) - _e12713) * _e12735);
let _e12747 = select(0f, _e12738, (((_e12741 >= 0f) && (_e12741 < _e691)) && (_e12738 > 0f)));
let _e12749 = (_e12598 << bitcast<u32>(_e7203));
let _e12761 = (_e12570 + 1i);
let _e12764 = select(_e12761, 0i, (_e12761 < 0i));
let _e12765 = (_e12764 >= _e12545.member);
if _e12765 {
phi_31729_ = (_e12545.member - 1i);
} else {
phi_31729_ = _e12764;
}
let _e12768 = phi_31729_;
if _e12601 {
phi_31740_ = (_e12545.member_1 - 1i);
} else {
phi_31740_ = _e12600;
}
let _e12771 = phi_31740_;
let _e12775 = (((f32(_e12768) + 0.5f) * _e12550) - 0.5f);
let _e12779 = (((f32(_e12771) + 0.5f) * _e12550) - 0.5f);
if _e453 {
phi_31768_ = type_23(_e12771, _e12768);
} else {
phi_31768_ = type_23(_e12768, _e12771);
}
let _e12785 = phi_31768_;
if _e986 {
phi_31819_ = 0u;
} else {
if (_e766 == 1u) {
phi_31818_ = 0u;
} else {
if (_e766 == 2u) {
phi_31817_ = _e12627;
} else {
phi_31817_ = select(_e12633, _e12630, (_e766 == 3u));
}
let _e12793 = phi_31817_;
phi_31818_ = _e12793;
}
let _e12795 = phi_31818_;
phi_31819_ = _e12795;
}
let _e12797 = phi_31819_;
local_100 = (((bitcast<i32>(_e12797) + _e12785.member_1) * _e12624) + _e12785.member);
let _e12802 = local_100;
let _e12804 = select(_e12650, _e12802, (_e12802 < _e12650));
let _e12809 = global_6.member[bitcast<u32>(select(0i, _e12804, (_e12804 > 0i)))];
let _e12814 = (((((select(_e12775, _e12779, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e12819 = ((1f - (((select(_e12779, _e12775, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e12826 = ((_e11792.member * _e12814) + (_e11800.member * _e12819));
let _e12827 = ((_e11792.member_1 * _e12814) + (_e11800.member_1 * _e12819));
let _e12828 = ((_e11792.member_2 * _e12814) + (_e11800.member_2 * _e12819));
let _e12832 = select((_e11815.member + _e12826), _e11815.member, _e11813);
let _e12833 = select((_e11815.member_1 + _e12827), _e11815.member_1, _e11813);
let _e12834 = select((_e11815.member_2 + _e12828), _e11815.member_2, _e11813);
let _e12845 = (((_e12832 * _e12832) + (_e12833 * _e12833)) + (_e12834 * _e12834));
let _e12849 = (1f / sqrt(select(0f, _e12845, (_e12845 > 0f))));
let _e12850 = (_e12832 * _e12849);
let _e12851 = (_e12833 * _e12849);
let _e12852 = (_e12834 * _e12849);
let _e12853 = (_e575 - select(_e11826.member, (_e11826.member + _e12826), _e11813));
let _e12854 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e12827), _e11813));
let _e12855 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e12828), _e11813));
let _e12860 = (((_e12853 * _e12850) + (_e12854 * _e12851)) + (_e12855 * _e12852));
let _e12865 = (((_e12853 * _e613) + (_e12854 * _e626)) + (_e12855 * _e639));
let _e12870 = (((_e12850 * _e613) + (_e12851 * _e626)) + (_e12852 * _e639));
let _e12873 = ((_e12851 * _e639) - (_e12852 * _e626));
let _e12876 = ((_e12852 * _e613) - (_e12850 * _e639));
let _e12879 = ((_e12850 * _e626) - (_e12851 * _e613));
let _e12884 = (((_e12873 * _e12873) + (_e12876 * _e12876)) + (_e12879 * _e12879));
let _e12887 = (1f / select(1e-9f, _e12884, (_e12884 > 1e-9f)));
let _e12890 = ((_e12860 - (_e12870 * _e12865)) * _e12887);
let _e12893 = (((_e12870 * _e12860) - _e12865) * _e12887);
let _e12899 = select(0f, _e12890, (((_e12893 >= 0f) && (_e12893 < _e691)) && (_e12890 > 0f)));
let _e12901 = (_e12768 << bitcast<u32>(_e7203));
let _e12913 = (_e12585 + 1i);
if _e12595 {
phi_32480_ = (_e12545.member - 1i);
} else {
phi_32480_ = _e12594;
}
let _e12917 = phi_32480_;
let _e12919 = select(_e12913, 0i, (_e12913 < 0i));
let _e12920 = (_e12919 >= _e12545.member_1);
if _e12920 {
phi_32491_ = (_e12545.member_1 - 1i);
} else {
phi_32491_ = _e12919;
}
let _e12923 = phi_32491_;
let _e12927 = (((f32(_e12917) + 0.5f) * _e12550) - 0.5f);
let _e12931 = (((f32(_e12923) + 0.5f) * _e12550) - 0.5f);
if _e453 {
phi_32519_ = type_23(_e12923, _e12917);
} else {
phi_32519_ = type_23(_e12917, _e12923);
}
let _e12937 = phi_32519_;
if _e986 {
phi_32570_ = 0u;
} else {
if (_e766 == 1u) {
phi_32569_ = 0u;
} else {
if (_e766 == 2u) {
phi_32568_ = _e12627;
} else {
phi_32568_ = select(_e12633, _e12630, (_e766 == 3u));
}
let _e12945 = phi_32568_;
phi_32569_ = _e12945;
}
let _e12947 = phi_32569_;
phi_32570_ = _e12947;
}
let _e12949 = phi_32570_;
local_98 = (((bitcast<i32>(_e12949) + _e12937.member_1) * _e12624) + _e12937.member);
let _e12954 = local_98;
let _e12956 = select(_e12650, _e12954, (_e12954 < _e12650));
let _e12961 = global_6.member[bitcast<u32>(select(0i, _e12956, (_e12956 > 0i)))];
let _e12966 = (((((select(_e12927, _e12931, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e12971 = ((1f - (((select(_e12931, _e12927, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e12978 = ((_e11792.member * _e12966) + (_e11800.member * _e12971));
let _e12979 = ((_e11792.member_1 * _e12966) + (_e11800.member_1 * _e12971));
let _e12980 = ((_e11792.member_2 * _e12966) + (_e11800.member_2 * _e12971));
let _e12984 = select((_e11815.member + _e12978), _e11815.member, _e11813);
let _e12985 = select((_e11815.member_1 + _e12979), _e11815.member_1, _e11813);
let _e12986 = select((_e11815.member_2 + _e12980), _e11815.member_2, _e11813);
let _e12997 = (((_e12984 * _e12984) + (_e12985 * _e12985)) + (_e12986 * _e12986));
let _e13001 = (1f / sqrt(select(0f, _e12997, (_e12997 > 0f))));
let _e13002 = (_e12984 * _e13001);
let _e13003 = (_e12985 * _e13001);
let _e13004 = (_e12986 * _e13001);
let _e13005 = (_e575 - select(_e11826.member, (_e11826.member + _e12978), _e11813));
let _e13006 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e12979), _e11813));
let _e13007 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e12980), _e11813));
let _e13012 = (((_e13005 * _e13002) + (_e13006 * _e13003)) + (_e13007 * _e13004));
let _e13017 = (((_e13005 * _e613) + (_e13006 * _e626)) + (_e13007 * _e639));
let _e13022 = (((_e13002 * _e613) + (_e13003 * _e626)) + (_e13004 * _e639));
let _e13025 = ((_e13003 * _e639) - (_e13004 * _e626));
let _e13028 = ((_e13004 * _e613) - (_e13002 * _e639));
let _e13031 = ((_e13002 * _e626) - (_e13003 * _e613));
let _e13036 = (((_e13025 * _e13025) + (_e13028 * _e13028)) + (_e13031 * _e13031));
let _e13039 = (1f / select(1e-9f, _e13036, (_e13036 > 1e-9f)));
let _e13042 = ((_e13012 - (_e13022 * _e13017)) * _e13039);
let _e13045 = (((_e13022 * _e13012) - _e13017) * _e13039);
let _e13051 = select(0f, _e13042, (((_e13045 >= 0f) && (_e13045 < _e691)) && (_e13042 > 0f)));
let _e13053 = (_e12917 << bitcast<u32>(_e7203));
if _e12765 {
phi_33231_ = (_e12545.member - 1i);
} else {
phi_33231_ = _e12764;
}
let _e13068 = phi_33231_;
if _e12920 {
phi_33242_ = (_e12545.member_1 - 1i);
} else {
phi_33242_ = _e12919;
}
let _e13071 = phi_33242_;
let _e13075 = (((f32(_e13068) + 0.5f) * _e12550) - 0.5f);
let _e13079 = (((f32(_e13071) + 0.5f) * _e12550) - 0.5f);
if _e453 {
phi_33270_ = type_23(_e13071, _e13068);
} else {
phi_33270_ = type_23(_e13068, _e13071);
}
let _e13085 = phi_33270_;
if _e986 {
phi_33321_ = 0u;
} else {
if (_e766 == 1u) {
phi_33320_ = 0u;
} else {
if (_e766 == 2u) {
phi_33319_ = _e12627;
} else {
phi_33319_ = select(_e12633, _e12630, (_e766 == 3u));
}
let _e13093 = phi_33319_;
phi_33320_ = _e13093;
}
let _e13095 = phi_33320_;
phi_33321_ = _e13095;
}
let _e13097 = phi_33321_;
local_96 = (((bitcast<i32>(_e13097) + _e13085.member_1) * _e12624) + _e13085.member);
let _e13102 = local_96;
let _e13104 = select(_e12650, _e13102, (_e13102 < _e12650));
let _e13109 = global_6.member[bitcast<u32>(select(0i, _e13104, (_e13104 > 0i)))];
let _e13114 = (((((select(_e13075, _e13079, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e13119 = ((1f - (((select(_e13079, _e13075, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e13126 = ((_e11792.member * _e13114) + (_e11800.member * _e13119));
let _e13127 = ((_e11792.member_1 * _e13114) + (_e11800.member_1 * _e13119));
let _e13128 = ((_e11792.member_2 * _e13114) + (_e11800.member_2 * _e13119));
let _e13132 = select((_e11815.member + _e13126), _e11815.member, _e11813);
let _e13133 = select((_e11815.member_1 + _e13127), _e11815.member_1, _e11813);
let _e13134 = select((_e11815.member_2 + _e13128), _e11815.member_2, _e11813);
let _e13145 = (((_e13132 * _e13132) + (_e13133 * _e13133)) + (_e13134 * _e13134));
let _e13149 = (1f / sqrt(select(0f, _e13145, (_e13145 > 0f))));
let _e13150 = (_e13132 * _e13149);
let _e13151 = (_e13133 * _e13149);
let _e13152 = (_e13134 * _e13149);
let _e13153 = (_e575 - select(_e11826.member, (_e11826.member + _e13126), _e11813));
let _e13154 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e13127), _e11813));
let _e13155 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e13128), _e11813));
let _e13160 = (((_e13153 * _e13150) + (_e13154 * _e13151)) + (_e13155 * _e13152));
let _e13165 = (((_e13153 * _e613) + (_e13154 * _e626)) + (_e13155 * _e639));
let _e13170 = (((_e13150 * _e613) + (_e13151 * _e626)) + (_e13152 * _e639));
let _e13173 = ((_e13151 * _e639) - (_e13152 * _e626));
let _e13176 = ((_e13152 * _e613) - (_e13150 * _e639));
let _e13179 = ((_e13150 * _e626) - (_e13151 * _e613));
let _e13184 = (((_e13173 * _e13173) + (_e13176 * _e13176)) + (_e13179 * _e13179));
let _e13187 = (1f / select(1e-9f, _e13184, (_e13184 > 1e-9f)));
let _e13190 = ((_e13160 - (_e13170 * _e13165)) * _e13187);
let _e13193 = (((_e13170 * _e13160) - _e13165) * _e13187);
let _e13199 = select(0f, _e13190, (((_e13193 >= 0f) && (_e13193 < _e691)) && (_e13190 > 0f)));
let _e13201 = (_e13068 << bitcast<u32>(_e7203));
let _e13213 = select(((((1f - select(0f, (_e12590 * _e12591), (((select(select(_e766, _e927, (_e12749 >= _e692)), _e847, (_e12749 < _e298)) == _e766) && (_e12747 > 0f)) && (_e12747 < _e12657)))) - select(0f, (_e12587 * _e12591), (((select(select(_e766, _e927, (_e12901 >= _e692)), _e847, (_e12901 < _e298)) == _e766) && (_e12899 > 0f)) && (_e12899 < _e12809)))) - select(0f, (_e12590 * _e12589), (((select(select(_e766, _e927, (_e13053 >= _e692)), _e847, (_e13053 < _e298)) == _e766) && (_e13051 > 0f)) && (_e13051 < _e12961)))) - select(0f, (_e12587 * _e12589), (((select(select(_e766, _e927, (_e13201 >= _e692)), _e847, (_e13201 < _e298)) == _e766) && (_e13199 > 0f)) && (_e13199 < _e13109)))), 1f, _e986);
let _e13214 = (_e8554 & 31u);
let _e13216 = (1u << bitcast<u32>(_e13214));
let _e13225 = bitcast<i32>((((_e931 + _e13216) - 1u) >> bitcast<u32>(_e13214)));
let _e13226 = bitcast<i32>((((_e934 + _e13216) - 1u) >> bitcast<u32>(_e13214)));
if _e453 {
phi_34000_ = type_23(_e13226, _e13225);
} else {
phi_34000_ = type_23(_e13225, _e13226);
}
let _e13230 = phi_34000_;
let _e13235 = f32((1i << bitcast<u32>(_e13214)));
let _e13236 = (1f / _e13235);
let _e13238 = ((_e11587 * _e13236) - 0.5f);
let _e13240 = ((_e11681 * _e13236) - 0.5f);
let _e13242 = select(-1f, _e13238, (_e13238 > -1f));
let _e13244 = select(1e6f, _e13242, (_e13242 < 1e6f));
let _e13251 = select(0i, select(select(i32(_e13244), i32(-2147483648), (_e13244 < -2147483600f)), 2147483647i, (_e13244 > 2147483500f)), (_e13244 == _e13244));
let _e13255 = (_e13251 - select(0i, 1i, (_e13244 < f32(_e13251))));
let _e13257 = select(-1f, _e13240, (_e13240 > -1f));
let _e13259 = select(1e6f, _e13257, (_e13257 < 1e6f));
let _e13266 = select(0i, select(select(i32(_e13259), i32(-2147483648), (_e13259 < -2147483600f)), 2147483647i, (_e13259 > 2147483500f)), (_e13259 == _e13259));
let _e13270 = (_e13266 - select(0i, 1i, (_e13259 < f32(_e13266))));
let _e13272 = (_e13238 - f32(_e13255));
let _e13274 = (_e13240 - f32(_e13270));
let _e13275 = (1f - _e13272);
let _e13276 = (1f - _e13274);
let _e13279 = select(_e13255, 0i, (_e13255 < 0i));
let _e13280 = (_e13279 >= _e13230.member);
if _e13280 {
phi_34078_ = (_e13230.member - 1i);
} else {
phi_34078_ = _e13279;
}
let _e13283 = phi_34078_;
let _e13285 = select(_e13270, 0i, (_e13270 < 0i));
let _e13286 = (_e13285 >= _e13230.member_1);
if _e13286 {
phi_34089_ = (_e13230.member_1 - 1i);
} else {
phi_34089_ = _e13285;
}
let _e13289 = phi_34089_;
let _e13293 = (((f32(_e13283) + 0.5f) * _e13235) - 0.5f);
let _e13297 = (((f32(_e13289) + 0.5f) * _e13235) - 0.5f);
if _e453 {
phi_34117_ = type_23(_e13289, _e13283);
} else {
phi_34117_ = type_23(_e13283, _e13289);
}
let _e13303 = phi_34117_;
let _e13306 = (_e8554 == 0u);
if _e13306 {
phi_34168_ = 0u;
} else {
if (_e8554 == 1u) {
phi_34167_ = 0u;
} else {
if (_e8554 == 2u) {
phi_34166_ = _e12627;
} else {
phi_34166_ = select(_e12633, _e12630, (_e8554 == 3u));
}
let _e13312 = phi_34166_;
phi_34167_ = _e13312;
}
let _e13314 = phi_34167_;
phi_34168_ = _e13314;
}
let _e13316 = phi_34168_;
local_94 = (((bitcast<i32>(_e13316) + _e13303.member_1) * _e12624) + _e13303.member);
let _e13321 = local_94;
let _e13323 = select(_e12650, _e13321, (_e13321 < _e12650));
let _e13328 = global_6.member[bitcast<u32>(select(0i, _e13323, (_e13323 > 0i)))];
let _e13333 = (((((select(_e13293, _e13297, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e13338 = ((1f - (((select(_e13297, _e13293, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e13345 = ((_e11792.member * _e13333) + (_e11800.member * _e13338));
let _e13346 = ((_e11792.member_1 * _e13333) + (_e11800.member_1 * _e13338));
let _e13347 = ((_e11792.member_2 * _e13333) + (_e11800.member_2 * _e13338));
let _e13351 = select((_e11815.member + _e13345), _e11815.member, _e11813);
let _e13352 = select((_e11815.member_1 + _e13346), _e11815.member_1, _e11813);
let _e13353 = select((_e11815.member_2 + _e13347), _e11815.member_2, _e11813);
let _e13364 = (((_e13351 * _e13351) + (_e13352 * _e13352)) + (_e13353 * _e13353));
let _e13368 = (1f / sqrt(select(0f, _e13364, (_e13364 > 0f))));
let _e13369 = (_e13351 * _e13368);
let _e13370 = (_e13352 * _e13368);
let _e13371 = (_e13353 * _e13368);
let _e13372 = (_e575 - select(_e11826.member, (_e11826.member + _e13345), _e11813));
let _e13373 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e13346), _e11813));
let _e13374 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e13347), _e11813));
let _e13379 = (((_e13372 * _e13369) + (_e13373 * _e13370)) + (_e13374 * _e13371));
let _e13384 = (((_e13372 * _e613) + (_e13373 * _e626)) + (_e13374 * _e639));
let _e13389 = (((_e13369 * _e613) + (_e13370 * _e626)) + (_e13371 * _e639));
let _e13392 = ((_e13370 * _e639) - (_e13371 * _e626));
let _e13395 = ((_e13371 * _e613) - (_e13369 * _e639));
let _e13398 = ((_e13369 * _e626) - (_e13370 * _e613));
let _e13403 = (((_e13392 * _e13392) + (_e13395 * _e13395)) + (_e13398 * _e13398));
let _e13406 = (1f / select(1e-9f, _e13403, (_e13403 > 1e-9f)));
let _e13409 = ((_e13379 - (_e13389 * _e13384)) * _e13406);
let _e13412 = (((_e13389 * _e13379) - _e13384) * _e13406);
let _e13418 = select(0f, _e13409, (((_e13412 >= 0f) && (_e13412 < _e691)) && (_e13409 > 0f)));
let _e13420 = (_e13283 << bitcast<u32>(_e13214));
let _e13432 = (_e13255 + 1i);
let _e13435 = select(_e13432, 0i, (_e13432 < 0i));
let _e13436 = (_e13435 >= _e13230.member);
if _e13436 {
phi_34829_ = (_e13230.member - 1i);
} else {
phi_34829_ = _e13435;
}
let _e13439 = phi_34829_;
if _e13286 {
phi_34840_ = (_e13230.member_1 - 1i);
} else {
phi_34840_ = _e13285;
}
let _e13442 = phi_34840_;
let _e13446 = (((f32(_e13439) + 0.5f) * _e13235) - 0.5f);
let _e13450 = (((f32(_e13442) + 0.5f) * _e13235) - 0.5f);
if _e453 {
phi_34868_ = type_23(_e13442, _e13439);
} else {
phi_34868_ = type_23(_e13439, _e13442);
}
let _e13456 = phi_34868_;
if _e13306 {
phi_34919_ = 0u;
} else {
if (_e8554 == 1u) {
phi_34918_ = 0u;
} else {
if (_e8554 == 2u) {
phi_34917_ = _e12627;
} else {
phi_34917_ = select(_e12633, _e12630, (_e8554 == 3u));
}
let _e13464 = phi_34917_;
phi_34918_ = _e13464;
}
let _e13466 = phi_34918_;
phi_34919_ = _e13466;
}
let _e13468 = phi_34919_;
local_92 = (((bitcast<i32>(_e13468) + _e13456.member_1) * _e12624) + _e13456.member);
let _e13473 = local_92;
let _e13475 = select(_e12650, _e13473, (_e13473 < _e12650));
let _e13480 = global_6.member[bitcast<u32>(select(0i, _e13475, (_e13475 > 0i)))];
let _e13485 = (((((select(_e13446, _e13450, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e13490 = ((1f - (((select(_e13450, _e13446, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e13497 = ((_e11792.member * _e13485) + (_e11800.member * _e13490));
let _e13498 = ((_e11792.member_1 * _e13485) + (_e11800.member_1 * _e13490));
let _e13499 = ((_e11792.member_2 * _e13485) + (_e11800.member_2 * _e13490));
let _e13503 = select((_e11815.member + _e13497), _e11815.member, _e11813);
let _e13504 = select((_e11815.member_1 + _e13498), _e11815.member_1, _e11813);
let _e13505 = select((_e11815.member_2 + _e13499), _e11815.member_2, _e11813);
let _e13516 = (((_e13503 * _e13503) + (_e13504 * _e13504)) + (_e13505 * _e13505));
let _e13520 = (1f / sqrt(select(0f, _e13516, (_e13516 > 0f))));
let _e13521 = (_e13503 * _e13520);
let _e13522 = (_e13504 * _e13520);
let _e13523 = (_e13505 * _e13520);
let _e13524 = (_e575 - select(_e11826.member, (_e11826.member + _e13497), _e11813));
let _e13525 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e13498), _e11813));
let _e13526 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e13499), _e11813));
let _e13531 = (((_e13524 * _e13521) + (_e13525 * _e13522)) + (_e13526 * _e13523));
let _e13536 = (((_e13524 * _e613) + (_e13525 * _e626)) + (_e13526 * _e639));
let _e13541 = (((_e13521 * _e613) + (_e13522 * _e626)) + (_e13523 * _e639));
let _e13544 = ((_e13522 * _e639) - (_e13523 * _e626));
let _e13547 = ((_e13523 * _e613) - (_e13521 * _e639));
let _e13550 = ((_e13521 * _e626) - (_e13522 * _e613));
let _e13555 = (((_e13544 * _e13544) + (_e13547 * _e13547)) + (_e13550 * _e13550));
let _e13558 = (1f / select(1e-9f, _e13555, (_e13555 > 1e-9f)));
let _e13561 = ((_e13531 - (_e13541 * _e13536)) * _e13558);
let _e13564 = (((_e13541 * _e13531) - _e13536) * _e13558);
let _e13570 = select(0f, _e13561, (((_e13564 >= 0f) && (_e13564 < _e691)) && (_e13561 > 0f)));
let _e13572 = (_e13439 << bitcast<u32>(_e13214));
let _e13584 = (_e13270 + 1i);
if _e13280 {
phi_35580_ = (_e13230.member - 1i);
} else {
phi_35580_ = _e13279;
}
let _e13588 = phi_35580_;
let _e13590 = select(_e13584, 0i, (_e13584 < 0i));
let _e13591 = (_e13590 >= _e13230.member_1);
if _e13591 {
phi_35591_ = (_e13230.member_1 - 1i);
} else {
phi_35591_ = _e13590;
}
let _e13594 = phi_35591_;
let _e13598 = (((f32(_e13588) + 0.5f) * _e13235) - 0.5f);
let _e13602 = (((f32(_e13594) + 0.5f) * _e13235) - 0.5f);
if _e453 {
phi_35619_ = type_23(_e13594, _e13588);
} else {
phi_35619_ = type_23(_e13588, _e13594);
}
let _e13608 = phi_35619_;
if _e13306 {
phi_35670_ = 0u;
} else {
if (_e8554 == 1u) {
phi_35669_ = 0u;
} else {
if (_e8554 == 2u) {
phi_35668_ = _e12627;
} else {
phi_35668_ = select(_e12633, _e12630, (_e8554 == 3u));
}
let _e13616 = phi_35668_;
phi_35669_ = _e13616;
}
let _e13618 = phi_35669_;
phi_35670_ = _e13618;
}
let _e13620 = phi_35670_;
local_90 = (((bitcast<i32>(_e13620) + _e13608.member_1) * _e12624) + _e13608.member);
let _e13625 = local_90;
let _e13627 = select(_e12650, _e13625, (_e13625 < _e12650));
let _e13632 = global_6.member[bitcast<u32>(select(0i, _e13627, (_e13627 > 0i)))];
let _e13637 = (((((select(_e13598, _e13602, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e13642 = ((1f - (((select(_e13602, _e13598, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e13649 = ((_e11792.member * _e13637) + (_e11800.member * _e13642));
let _e13650 = ((_e11792.member_1 * _e13637) + (_e11800.member_1 * _e13642));
let _e13651 = ((_e11792.member_2 * _e13637) + (_e11800.member_2 * _e13642));
let _e13655 = select((_e11815.member + _e13649), _e11815.member, _e11813);
let _e13656 = select((_e11815.member_1 + _e13650), _e11815.member_1, _e11813);
let _e13657 = select((_e11815.member_2 + _e13651), _e11815.member_2, _e11813);
let _e13668 = (((_e13655 * _e13655) + (_e13656 * _e13656)) + (_e13657 * _e13657));
let _e13672 = (1f / sqrt(select(0f, _e13668, (_e13668 > 0f))));
let _e13673 = (_e13655 * _e13672);
let _e13674 = (_e13656 * _e13672);
let _e13675 = (_e13657 * _e13672);
let _e13676 = (_e575 - select(_e11826.member, (_e11826.member + _e13649), _e11813));
let _e13677 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e13650), _e11813));
let _e13678 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e13651), _e11813));
let _e13683 = (((_e13676 * _e13673) + (_e13677 * _e13674)) + (_e13678 * _e13675));
let _e13688 = (((_e13676 * _e613) + (_e13677 * _e626)) + (_e13678 * _e639));
let _e13693 = (((_e13673 * _e613) + (_e13674 * _e626)) + (_e13675 * _e639));
let _e13696 = ((_e13674 * _e639) - (_e13675 * _e626));
let _e13699 = ((_e13675 * _e613) - (_e13673 * _e639));
let _e13702 = ((_e13673 * _e626) - (_e13674 * _e613));
let _e13707 = (((_e13696 * _e13696) + (_e13699 * _e13699)) + (_e13702 * _e13702));
let _e13710 = (1f / select(1e-9f, _e13707, (_e13707 > 1e-9f)));
let _e13713 = ((_e13683 - (_e13693 * _e13688)) * _e13710);
let _e13716 = (((_e13693 * _e13683) - _e13688) * _e13710);
let _e13722 = select(0f, _e13713, (((_e13716 >= 0f) && (_e13716 < _e691)) && (_e13713 > 0f)));
let _e13724 = (_e13588 << bitcast<u32>(_e13214));
if _e13436 {
phi_36331_ = (_e13230.member - 1i);
} else {
phi_36331_ = _e13435;
}
let _e13739 = phi_36331_;
if _e13591 {
phi_36342_ = (_e13230.member_1 - 1i);
} else {
phi_36342_ = _e13590;
}
let _e13742 = phi_36342_;
let _e13746 = (((f32(_e13739) + 0.5f) * _e13235) - 0.5f);
let _e13750 = (((f32(_e13742) + 0.5f) * _e13235) - 0.5f);
if _e453 {
phi_36370_ = type_23(_e13742, _e13739);
} else {
phi_36370_ = type_23(_e13739, _e13742);
}
let _e13756 = phi_36370_;
if _e13306 {
phi_36421_ = 0u;
} else {
if (_e8554 == 1u) {
phi_36420_ = 0u;
} else {
if (_e8554 == 2u) {
phi_36419_ = _e12627;
} else {
phi_36419_ = select(_e12633, _e12630, (_e8554 == 3u));
}
let _e13764 = phi_36419_;
phi_36420_ = _e13764;
}
let _e13766 = phi_36420_;
phi_36421_ = _e13766;
}
let _e13768 = phi_36421_;
local_88 = (((bitcast<i32>(_e13768) + _e13756.member_1) * _e12624) + _e13756.member);
let _e13773 = local_88;
let _e13775 = select(_e12650, _e13773, (_e13773 < _e12650));
let _e13780 = global_6.member[bitcast<u32>(select(0i, _e13775, (_e13775 > 0i)))];
let _e13785 = (((((select(_e13746, _e13750, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e13790 = ((1f - (((select(_e13750, _e13746, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e13797 = ((_e11792.member * _e13785) + (_e11800.member * _e13790));
let _e13798 = ((_e11792.member_1 * _e13785) + (_e11800.member_1 * _e13790));
let _e13799 = ((_e11792.member_2 * _e13785) + (_e11800.member_2 * _e13790));
let _e13803 = select((_e11815.member + _e13797), _e11815.member, _e11813);
let _e13804 = select((_e11815.member_1 + _e13798), _e11815.member_1, _e11813);
let _e13805 = select((_e11815.member_2 + _e13799), _e11815.member_2, _e11813);
let _e13816 = (((_e13803 * _e13803) + (_e13804 * _e13804)) + (_e13805 * _e13805));
let _e13820 = (1f / sqrt(select(0f, _e13816, (_e13816 > 0f))));
let _e13821 = (_e13803 * _e13820);
let _e13822 = (_e13804 * _e13820);
let _e13823 = (_e13805 * _e13820);
let _e13824 = (_e575 - select(_e11826.member, (_e11826.member + _e13797), _e11813));
let _e13825 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e13798), _e11813));
let _e13826 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e13799), _e11813));
let _e13831 = (((_e13824 * _e13821) + (_e13825 * _e13822)) + (_e13826 * _e13823));
let _e13836 = (((_e13824 * _e613) + (_e13825 * _e626)) + (_e13826 * _e639));
let _e13841 = (((_e13821 * _e613) + (_e13822 * _e626)) + (_e13823 * _e639));
let _e13844 = ((_e13822 * _e639) - (_e13823 * _e626));
let _e13847 = ((_e13823 * _e613) - (_e13821 * _e639));
let _e13850 = ((_e13821 * _e626) - (_e13822 * _e613));
let _e13855 = (((_e13844 * _e13844) + (_e13847 * _e13847)) + (_e13850 * _e13850));
let _e13858 = (1f / select(1e-9f, _e13855, (_e13855 > 1e-9f)));
let _e13861 = ((_e13831 - (_e13841 * _e13836)) * _e13858);
let _e13864 = (((_e13841 * _e13831) - _e13836) * _e13858);
let _e13870 = select(0f, _e13861, (((_e13864 >= 0f) && (_e13864 < _e691)) && (_e13861 > 0f)));
let _e13872 = (_e13739 << bitcast<u32>(_e13214));
let _e13884 = select(((((_e13213 - select(0f, (_e13275 * _e13276), (((select(select(_e766, _e927, (_e13420 >= _e692)), _e847, (_e13420 < _e298)) == _e8554) && (_e13418 > 0f)) && (_e13418 < _e13328)))) - select(0f, (_e13272 * _e13276), (((select(select(_e766, _e927, (_e13572 >= _e692)), _e847, (_e13572 < _e298)) == _e8554) && (_e13570 > 0f)) && (_e13570 < _e13480)))) - select(0f, (_e13275 * _e13274), (((select(select(_e766, _e927, (_e13724 >= _e692)), _e847, (_e13724 < _e298)) == _e8554) && (_e13722 > 0f)) && (_e13722 < _e13632)))) - select(0f, (_e13272 * _e13274), (((select(select(_e766, _e927, (_e13872 >= _e692)), _e847, (_e13872 < _e298)) == _e8554) && (_e13870 > 0f)) && (_e13870 < _e13780)))), _e13213, _e13306);
let _e13885 = (_e8558 & 31u);
let _e13887 = (1u << bitcast<u32>(_e13885));
let _e13896 = bitcast<i32>((((_e931 + _e13887) - 1u) >> bitcast<u32>(_e13885)));
let _e13897 = bitcast<i32>((((_e934 + _e13887) - 1u) >> bitcast<u32>(_e13885)));
if _e453 {
phi_37100_ = type_23(_e13897, _e13896);
} else {
phi_37100_ = type_23(_e13896, _e13897);
}
let _e13901 = phi_37100_;
let _e13906 = f32((1i << bitcast<u32>(_e13885)));
let _e13907 = (1f / _e13906);
let _e13909 = ((_e11587 * _e13907) - 0.5f);
let _e13911 = ((_e11681 * _e13907) - 0.5f);
let _e13913 = select(-1f, _e13909, (_e13909 > -1f));
let _e13915 = select(1e6f, _e13913, (_e13913 < 1e6f));
let _e13922 = select(0i, select(select(i32(_e13915), i32(-2147483648), (_e13915 < -2147483600f)), 2147483647i, (_e13915 > 2147483500f)), (_e13915 == _e13915));
let _e13926 = (_e13922 - select(0i, 1i, (_e13915 < f32(_e13922))));
let _e13928 = select(-1f, _e13911, (_e13911 > -1f));
let _e13930 = select(1e6f, _e13928, (_e13928 < 1e6f));
let _e13937 = select(0i, select(select(i32(_e13930), i32(-2147483648), (_e13930 < -2147483600f)), 2147483647i, (_e13930 > 2147483500f)), (_e13930 == _e13930));
let _e13941 = (_e13937 - select(0i, 1i, (_e13930 < f32(_e13937))));
let _e13943 = (_e13909 - f32(_e13926));
let _e13945 = (_e13911 - f32(_e13941));
let _e13946 = (1f - _e13943);
let _e13947 = (1f - _e13945);
let _e13950 = select(_e13926, 0i, (_e13926 < 0i));
let _e13951 = (_e13950 >= _e13901.member);
if _e13951 {
phi_37178_ = (_e13901.member - 1i);
} else {
phi_37178_ = _e13950;
}
let _e13954 = phi_37178_;
let _e13956 = select(_e13941, 0i, (_e13941 < 0i));
let _e13957 = (_e13956 >= _e13901.member_1);
if _e13957 {
phi_37189_ = (_e13901.member_1 - 1i);
} else {
phi_37189_ = _e13956;
}
let _e13960 = phi_37189_;
let _e13964 = (((f32(_e13954) + 0.5f) * _e13906) - 0.5f);
let _e13968 = (((f32(_e13960) + 0.5f) * _e13906) - 0.5f);
if _e453 {
phi_37217_ = type_23(_e13960, _e13954);
} else {
phi_37217_ = type_23(_e13954, _e13960);
}
let _e13974 = phi_37217_;
let _e13977 = (_e8558 == 0u);
if _e13977 {
phi_37268_ = 0u;
} else {
if (_e8558 == 1u) {
phi_37267_ = 0u;
} else {
if (_e8558 == 2u) {
phi_37266_ = _e12627;
} else {
phi_37266_ = select(_e12633, _e12630, (_e8558 == 3u));
}
let _e13983 = phi_37266_;
phi_37267_ = _e13983;
}
let _e13985 = phi_37267_;
phi_37268_ = _e13985;
}
let _e13987 = phi_37268_;
local_86 = (((bitcast<i32>(_e13987) + _e13974.member_1) * _e12624) + _e13974.member);
let _e13992 = local_86;
let _e13994 = select(_e12650, _e13992, (_e13992 < _e12650));
let _e13999 = global_6.member[bitcast<u32>(select(0i, _e13994, (_e13994 > 0i)))];
let _e14004 = (((((select(_e13964, _e13968, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e14009 = ((1f - (((select(_e13968, _e13964, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e14016 = ((_e11792.member * _e14004) + (_e11800.member * _e14009));
let _e14017 = ((_e11792.member_1 * _e14004) + (_e11800.member_1 * _e14009));
let _e14018 = ((_e11792.member_2 * _e14004) + (_e11800.member_2 * _e14009));
let _e14022 = select((_e11815.member + _e14016), _e11815.member, _e11813);
let _e14023 = select((_e11815.member_1 + _e14017), _e11815.member_1, _e11813);
let _e14024 = select((_e11815.member_2 + _e14018), _e11815.member_2, _e11813);
let _e14035 = (((_e14022 * _e14022) + (_e14023 * _e14023)) + (_e14024 * _e14024));
let _e14039 = (1f / sqrt(select(0f, _e14035, (_e14035 > 0f))));
let _e14040 = (_e14022 * _e14039);
let _e14041 = (_e14023 * _e14039);
let _e14042 = (_e14024 * _e14039);
let _e14043 = (_e575 - select(_e11826.member, (_e11826.member + _e14016), _e11813));
let _e14044 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e14017), _e11813));
let _e14045 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e14018), _e11813));
let _e14050 = (((_e14043 * _e14040) + (_e14044 * _e14041)) + (_e14045 * _e14042));
let _e14055 = (((_e14043 * _e613) + (_e14044 * _e626)) + (_e14045 * _e639));
let _e14060 = (((_e14040 * _e613) + (_e14041 * _e626)) + (_e14042 * _e639));
let _e14063 = ((_e14041 * _e639) - (_e14042 * _e626));
let _e14066 = ((_e14042 * _e613) - (_e14040 * _e639));
let _e14069 = ((_e14040 * _e626) - (_e14041 * _e613));
let _e14074 = (((_e14063 * _e14063) + (_e14066 * _e14066)) + (_e14069 * _e14069));
let _e14077 = (1f / select(1e-9f, _e14074, (_e14074 > 1e-9f)));
let _e14080 = ((_e14050 - (_e14060 * _e14055)) * _e14077);
let _e14083 = (((_e14060 * _e14050) - _e14055) * _e14077);
let _e14089 = select(0f, _e14080, (((_e14083 >= 0f) && (_e14083 < _e691)) && (_e14080 > 0f)));
let _e14091 = (_e13954 << bitcast<u32>(_e13885));
let _e14103 = (_e13926 + 1i);
let _e14106 = select(_e14103, 0i, (_e14103 < 0i));
let _e14107 = (_e14106 >= _e13901.member);
if _e14107 {
phi_37929_ = (_e13901.member - 1i);
} else {
phi_37929_ = _e14106;
}
let _e14110 = phi_37929_;
if _e13957 {
phi_37940_ = (_e13901.member_1 - 1i);
} else {
phi_37940_ = _e13956;
}
let _e14113 = phi_37940_;
let _e14117 = (((f32(_e14110) + 0.5f) * _e13906) - 0.5f);
let _e14121 = (((f32(_e14113) + 0.5f) * _e13906) - 0.5f);
if _e453 {
phi_37968_ = type_23(_e14113, _e14110);
} else {
phi_37968_ = type_23(_e14110, _e14113);
}
let _e14127 = phi_37968_;
if _e13977 {
phi_38019_ = 0u;
} else {
if (_e8558 == 1u) {
phi_38018_ = 0u;
} else {
if (_e8558 == 2u) {
phi_38017_ = _e12627;
} else {
phi_38017_ = select(_e12633, _e12630, (_e8558 == 3u));
}
let _e14135 = phi_38017_;
phi_38018_ = _e14135;
}
let _e14137 = phi_38018_;
phi_38019_ = _e14137;
}
let _e14139 = phi_38019_;
local_84 = (((bitcast<i32>(_e14139) + _e14127.member_1) * _e12624) + _e14127.member);
let _e14144 = local_84;
let _e14146 = select(_e12650, _e14144, (_e14144 < _e12650));
let _e14151 = global_6.member[bitcast<u32>(select(0i, _e14146, (_e14146 > 0i)))];
let _e14156 = (((((select(_e14117, _e14121, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e14161 = ((1f - (((select(_e14121, _e14117, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e14168 = ((_e11792.member * _e14156) + (_e11800.member * _e14161));
let _e14169 = ((_e11792.member_1 * _e14156) + (_e11800.member_1 * _e14161));
let _e14170 = ((_e11792.member_2 * _e14156) + (_e11800.member_2 * _e14161));
let _e14174 = select((_e11815.member + _e14168), _e11815.member, _e11813);
let _e14175 = select((_e11815.member_1 + _e14169), _e11815.member_1, _e11813);
let _e14176 = select((_e11815.member_2 + _e14170), _e11815.member_2, _e11813);
let _e14187 = (((_e14174 * _e14174) + (_e14175 * _e14175)) + (_e14176 * _e14176));
let _e14191 = (1f / sqrt(select(0f, _e14187, (_e14187 > 0f))));
let _e14192 = (_e14174 * _e14191);
let _e14193 = (_e14175 * _e14191);
let _e14194 = (_e14176 * _e14191);
let _e14195 = (_e575 - select(_e11826.member, (_e11826.member + _e14168), _e11813));
let _e14196 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e14169), _e11813));
let _e14197 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e14170), _e11813));
let _e14202 = (((_e14195 * _e14192) + (_e14196 * _e14193)) + (_e14197 * _e14194));
let _e14207 = (((_e14195 * _e613) + (_e14196 * _e626)) + (_e14197 * _e639));
let _e14212 = (((_e14192 * _e613) + (_e14193 * _e626)) + (_e14194 * _e639));
let _e14215 = ((_e14193 * _e639) - (_e14194 * _e626));
let _e14218 = ((_e14194 * _e613) - (_e14192 * _e639));
let _e14221 = ((_e14192 * _e626) - (_e14193 * _e613));
let _e14226 = (((_e14215 * _e14215) + (_e14218 * _e14218)) + (_e14221 * _e14221));
let _e14229 = (1f / select(1e-9f, _e14226, (_e14226 > 1e-9f)));
let _e14232 = ((_e14202 - (_e14212 * _e14207)) * _e14229);
let _e14235 = (((_e14212 * _e14202) - _e14207) * _e14229);
let _e14241 = select(0f, _e14232, (((_e14235 >= 0f) && (_e14235 < _e691)) && (_e14232 > 0f)));
let _e14243 = (_e14110 << bitcast<u32>(_e13885));
let _e14255 = (_e13941 + 1i);
if _e13951 {
phi_38680_ = (_e13901.member - 1i);
} else {
phi_38680_ = _e13950;
}
let _e14259 = phi_38680_;
let _e14261 = select(_e14255, 0i, (_e14255 < 0i));
let _e14262 = (_e14261 >= _e13901.member_1);
if _e14262 {
phi_38691_ = (_e13901.member_1 - 1i);
} else {
phi_38691_ = _e14261;
}
let _e14265 = phi_38691_;
let _e14269 = (((f32(_e14259) + 0.5f) * _e13906) - 0.5f);
let _e14273 = (((f32(_e14265) + 0.5f) * _e13906) - 0.5f);
if _e453 {
phi_38719_ = type_23(_e14265, _e14259);
} else {
phi_38719_ = type_23(_e14259, _e14265);
}
let _e14279 = phi_38719_;
if _e13977 {
phi_38770_ = 0u;
} else {
if (_e8558 == 1u) {
phi_38769_ = 0u;
} else {
if (_e8558 == 2u) {
phi_38768_ = _e12627;
} else {
phi_38768_ = select(_e12633, _e12630, (_e8558 == 3u));
}
let _e14287 = phi_38768_;
phi_38769_ = _e14287;
}
let _e14289 = phi_38769_;
phi_38770_ = _e14289;
}
let _e14291 = phi_38770_;
local_82 = (((bitcast<i32>(_e14291) + _e14279.member_1) * _e12624) + _e14279.member);
let _e14296 = local_82;
let _e14298 = select(_e12650, _e14296, (_e14296 < _e12650));
let _e14303 = global_6.member[bitcast<u32>(select(0i, _e14298, (_e14298 > 0i)))];
let _e14308 = (((((select(_e14269, _e14273, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e14313 = ((1f - (((select(_e14273, _e14269, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e14320 = ((_e11792.member * _e14308) + (_e11800.member * _e14313));
let _e14321 = ((_e11792.member_1 * _e14308) + (_e11800.member_1 * _e14313));
let _e14322 = ((_e11792.member_2 * _e14308) + (_e11800.member_2 * _e14313));
let _e14326 = select((_e11815.member + _e14320), _e11815.member, _e11813);
let _e14327 = select((_e11815.member_1 + _e14321), _e11815.member_1, _e11813);
let _e14328 = select((_e11815.member_2 + _e14322), _e11815.member_2, _e11813);
let _e14339 = (((_e14326 * _e14326) + (_e14327 * _e14327)) + (_e14328 * _e14328));
let _e14343 = (1f / sqrt(select(0f, _e14339, (_e14339 > 0f))));
let _e14344 = (_e14326 * _e14343);
let _e14345 = (_e14327 * _e14343);
let _e14346 = (_e14328 * _e14343);
let _e14347 = (_e575 - select(_e11826.member, (_e11826.member + _e14320), _e11813));
let _e14348 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e14321), _e11813));
let _e14349 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e14322), _e11813));
let _e14354 = (((_e14347 * _e14344) + (_e14348 * _e14345)) + (_e14349 * _e14346));
let _e14359 = (((_e14347 * _e613) + (_e14348 * _e626)) + (_e14349 * _e639));
let _e14364 = (((_e14344 * _e613) + (_e14345 * _e626)) + (_e14346 * _e639));
let _e14367 = ((_e14345 * _e639) - (_e14346 * _e626));
let _e14370 = ((_e14346 * _e613) - (_e14344 * _e639));
let _e14373 = ((_e14344 * _e626) - (_e14345 * _e613));
let _e14378 = (((_e14367 * _e14367) + (_e14370 * _e14370)) + (_e14373 * _e14373));
let _e14381 = (1f / select(1e-9f, _e14378, (_e14378 > 1e-9f)));
let _e14384 = ((_e14354 - (_e14364 * _e14359)) * _e14381);
let _e14387 = (((_e14364 * _e14354) - _e14359) * _e14381);
let _e14393 = select(0f, _e14384, (((_e14387 >= 0f) && (_e14387 < _e691)) && (_e14384 > 0f)));
let _e14395 = (_e14259 << bitcast<u32>(_e13885));
if _e14107 {
phi_39431_ = (_e13901.member - 1i);
} else {
phi_39431_ = _e14106;
}
let _e14410 = phi_39431_;
if _e14262 {
phi_39442_ = (_e13901.member_1 - 1i);
} else {
phi_39442_ = _e14261;
}
let _e14413 = phi_39442_;
let _e14417 = (((f32(_e14410) + 0.5f) * _e13906) - 0.5f);
let _e14421 = (((f32(_e14413) + 0.5f) * _e13906) - 0.5f);
if _e453 {
phi_39470_ = type_23(_e14413, _e14410);
} else {
phi_39470_ = type_23(_e14410, _e14413);
}
let _e14427 = phi_39470_;
if _e13977 {
phi_39521_ = 0u;
} else {
if (_e8558 == 1u) {
phi_39520_ = 0u;
} else {
if (_e8558 == 2u) {
phi_39519_ = _e12627;
} else {
phi_39519_ = select(_e12633, _e12630, (_e8558 == 3u));
}
let _e14435 = phi_39519_;
phi_39520_ = _e14435;
}
let _e14437 = phi_39520_;
phi_39521_ = _e14437;
}
let _e14439 = phi_39521_;
local_80 = (((bitcast<i32>(_e14439) + _e14427.member_1) * _e12624) + _e14427.member);
let _e14444 = local_80;
let _e14446 = select(_e12650, _e14444, (_e14444 < _e12650));
let _e14451 = global_6.member[bitcast<u32>(select(0i, _e14446, (_e14446 > 0i)))];
let _e14456 = (((((select(_e14417, _e14421, _e453) + 0.5f) / _e11773) * 2f) - 1f) * _e11781);
let _e14461 = ((1f - (((select(_e14421, _e14417, _e453) + 0.5f) / _e11774) * 2f)) * _e11789);
let _e14468 = ((_e11792.member * _e14456) + (_e11800.member * _e14461));
let _e14469 = ((_e11792.member_1 * _e14456) + (_e11800.member_1 * _e14461));
let _e14470 = ((_e11792.member_2 * _e14456) + (_e11800.member_2 * _e14461));
let _e14474 = select((_e11815.member + _e14468), _e11815.member, _e11813);
let _e14475 = select((_e11815.member_1 + _e14469), _e11815.member_1, _e11813);
let _e14476 = select((_e11815.member_2 + _e14470), _e11815.member_2, _e11813);
let _e14487 = (((_e14474 * _e14474) + (_e14475 * _e14475)) + (_e14476 * _e14476));
let _e14491 = (1f / sqrt(select(0f, _e14487, (_e14487 > 0f))));
let _e14492 = (_e14474 * _e14491);
let _e14493 = (_e14475 * _e14491);
let _e14494 = (_e14476 * _e14491);
let _e14495 = (_e575 - select(_e11826.member, (_e11826.member + _e14468), _e11813));
let _e14496 = (_e587 - select(_e11826.member_1, (_e11826.member_1 + _e14469), _e11813));
let _e14497 = (_e600 - select(_e11826.member_2, (_e11826.member_2 + _e14470), _e11813));
let _e14502 = (((_e14495 * _e14492) + (_e14496 * _e14493)) + (_e14497 * _e14494));
let _e14507 = (((_e14495 * _e613) + (_e14496 * _e626)) + (_e14497 * _e639));
let _e14512 = (((_e14492 * _e613) + (_e14493 * _e626)) + (_e14494 * _e639));
let _e14515 = ((_e14493 * _e639) - (_e14494 * _e626));
let _e14518 = ((_e14494 * _e613) - (_e14492 * _e639));
let _e14521 = ((_e14492 * _e626) - (_e14493 * _e613));
let _e14526 = (((_e14515 * _e14515) + (_e14518 * _e14518)) + (_e14521 * _e14521));
let _e14529 = (1f / select(1e-9f, _e14526, (_e14526 > 1e-9f)));
let _e14532 = ((_e14502 - (_e14512 * _e14507)) * _e14529);
let _e14535 = (((_e14512 * _e14502) - _e14507) * _e14529);
let _e14541 = select(0f, _e14532, (((_e14535 >= 0f) && (_e14535 < _e691)) && (_e14532 > 0f)));
let _e14543 = (_e14410 << bitcast<u32>(_e13885));
let _e14555 = select(((((_e13884 - select(0f, (_e13946 * _e13947), (((select(select(_e766, _e927, (_e14091 >= _e692)), _e847, (_e14091 < _e298)) == _e8558) && (_e14089 > 0f)) && (_e14089 < _e13999)))) - select(0f, (_e13943 * _e13947), (((select(select(_e766, _e927, (_e14243 >= _e692)), _e847, (_e14243 < _e298)) == _e8558) && (_e14241 > 0f)) && (_e14241 < _e14151)))) - select(0f, (_e13946 * _e13945), (((select(select(_e766, _e927, (_e14395 >= _e692)), _e847, (_e14395 < _e298)) == _e8558) && (_e14393 > 0f)) && (_e14393 < _e14303)))) - select(0f, (_e13943 * _e13945), (((select(select(_e766, _e927, (_e14543 >= _e692)), _e847, (_e14543 < _e298)) == _e8558) && (_e14541 > 0f)) && (_e14541 < _e14451)))), _e13884, _e13977);
if _e453 {
phi_40191_ = type_23(_e11678, _e11585);
} else {
phi_40191_ = type_23(_e11585, _e11678);
}
let _e14570 = phi_40191_;
let _e14573 = (_e11679 && (((_e12541 > 0f) && (_e12541 < _e11769)) && (bitcast<f32>((bitcast<u32>(_e14555) & 2147483647u)) > 1e-6f)));
let _e14576 = global_1.member.member_18.member;
let _e14577 = (((select(_e11704, (1f - _e11704), (_e11689 >= 0f)) - select(_e11723, (1f - _e11723), (_e11708 >= 0f))) * (1f / _e11686)) * _e14576);
let _e14581 = select(0f, (((((_e652 * _e12378.member) * ((1f + (_e12418 * (1f + (_e12418 * (0.5f + (_e12418 * (0.16666667f + (_e12418 * (0.041666668f + (_e12418 * (0.008333334f + (_e12418 * (0.001388889f + (_e12418 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12413 + 127i)) << bitcast<u32>(23i))))) * _e12375) * _e14555) * _e14577), _e14573);
let _e14582 = select(0f, (((((_e665 * _e12378.member_1) * ((1f + (_e12466 * (1f + (_e12466 * (0.5f + (_e12466 * (0.16666667f + (_e12466 * (0.041666668f + (_e12466 * (0.008333334f + (_e12466 * (0.001388889f + (_e12466 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12461 + 127i)) << bitcast<u32>(23i))))) * _e12375) * _e14555) * _e14577), _e14573);
let _e14583 = select(0f, (((((_e678 * _e12378.member_2) * ((1f + (_e12514 * (1f + (_e12514 * (0.5f + (_e12514 * (0.16666667f + (_e12514 * (0.041666668f + (_e12514 * (0.008333334f + (_e12514 * (0.001388889f + (_e12514 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12509 + 127i)) << bitcast<u32>(23i))))) * _e12375) * _e14555) * _e14577), _e14573);
let _e14587 = (bitcast<f32>((bitcast<u32>(_e14581) & 2147483647u)) >= 1073741800f);
let _e14588 = (1f / 1048576f);
let _e14591 = ((_e14581 * select(1f, _e14588, _e14587)) + 0.5f);
let _e14593 = select(-1073741800f, _e14591, (_e14591 > -1073741800f));
let _e14595 = select(1073741800f, _e14593, (_e14593 < 1073741800f));
let _e14602 = select(0i, select(select(i32(_e14595), i32(-2147483648), (_e14595 < -2147483600f)), 2147483647i, (_e14595 > 2147483500f)), (_e14595 == _e14595));
let _e14606 = (_e14602 - select(0i, 1i, (_e14595 < f32(_e14602))));
let _e14607 = select(0i, 20i, _e14587);
let _e14611 = (bitcast<u32>(_e14606) << bitcast<u32>((_e14607 & 31i)));
let _e14618 = bitcast<u32>(((_e14606 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e14607) & 31i))));
let _e14622 = (bitcast<f32>((bitcast<u32>(_e14582) & 2147483647u)) >= 1073741800f);
let _e14625 = ((_e14582 * select(1f, _e14588, _e14622)) + 0.5f);
let _e14627 = select(-1073741800f, _e14625, (_e14625 > -1073741800f));
let _e14629 = select(1073741800f, _e14627, (_e14627 < 1073741800f));
let _e14636 = select(0i, select(select(i32(_e14629), i32(-2147483648), (_e14629 < -2147483600f)), 2147483647i, (_e14629 > 2147483500f)), (_e14629 == _e14629));
let _e14640 = (_e14636 - select(0i, 1i, (_e14629 < f32(_e14636))));
let _e14641 = select(0i, 20i, _e14622);
let _e14645 = (bitcast<u32>(_e14640) << bitcast<u32>((_e14641 & 31i)));
let _e14652 = bitcast<u32>(((_e14640 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e14641) & 31i))));
let _e14656 = (bitcast<f32>((bitcast<u32>(_e14583) & 2147483647u)) >= 1073741800f);
let _e14659 = ((_e14583 * select(1f, _e14588, _e14656)) + 0.5f);
let _e14661 = select(-1073741800f, _e14659, (_e14659 > -1073741800f));
let _e14663 = select(1073741800f, _e14661, (_e14661 < 1073741800f));
let _e14670 = select(0i, select(select(i32(_e14663), i32(-2147483648), (_e14663 < -2147483600f)), 2147483647i, (_e14663 > 2147483500f)), (_e14663 == _e14663));
let _e14674 = (_e14670 - select(0i, 1i, (_e14663 < f32(_e14670))));
let _e14675 = select(0i, 20i, _e14656);
let _e14679 = (bitcast<u32>(_e14674) << bitcast<u32>((_e14675 & 31i)));
let _e14686 = bitcast<u32>(((_e14674 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e14675) & 31i))));
let _e14691 = bitcast<i32>(bitcast<u32>((((_e14570.member_1 * _e935) + _e14570.member) * 6i)));
if ((_e14611 | _e14618) == 0u) {
} else {
let _e14694 = bitcast<u32>(_e14691);
if (_e14694 < _e270) {
let _e14698 = atomicAdd((&global_8.member[_e14694]), _e14611);
phi_40424_ = _e14698;
} else {
phi_40424_ = 0u;
}
let _e14700 = phi_40424_;
let _e14704 = (_e14618 + select(0u, 1u, ((_e14700 + _e14611) < _e14611)));
if (_e14704 == 0u) {
} else {
let _e14706 = (_e14694 + 1u);
if (_e14706 < _e270) {
let _e14710 = atomicAdd((&global_8.member[_e14706]), _e14704);
}
}
}
if ((_e14645 | _e14652) == 0u) {
} else {
let _e14714 = bitcast<u32>((_e14691 + 2i));
if (_e14714 < _e270) {
let _e14718 = atomicAdd((&global_8.member[_e14714]), _e14645);
phi_40454_ = _e14718;
} else {
phi_40454_ = 0u;
}
let _e14720 = phi_40454_;
let _e14724 = (_e14652 + select(0u, 1u, ((_e14720 + _e14645) < _e14645)));
if (_e14724 == 0u) {
} else {
let _e14726 = (_e14714 + 1u);
if (_e14726 < _e270) {
let _e14730 = atomicAdd((&global_8.member[_e14726]), _e14724);
}
}
}
if ((_e14679 | _e14686) == 0u) {
} else {
let _e14734 = bitcast<u32>((_e14691 + 4i));
if (_e14734 < _e270) {
let _e14738 = atomicAdd((&global_8.member[_e14734]), _e14679);
phi_40484_ = _e14738;
} else {
phi_40484_ = 0u;
}
let _e14740 = phi_40484_;
let _e14744 = (_e14686 + select(0u, 1u, ((_e14740 + _e14679) < _e14679)));
if (_e14744 == 0u) {
} else {
let _e14746 = (_e14734 + 1u);
if (_e14746 < _e270) {
let _e14750 = atomicAdd((&global_8.member[_e14746]), _e14744);
}
}
}
phi_29502_ = (_e11676 + 1i);
} else {
phi_29502_ = i32();
}
let _e14753 = phi_29502_;
continue;
continuing {
phi_29501_ = _e14753;
break if !(_e11679);
}
}
phi_29348_ = (_e11582 + 1i);
} else {
phi_29348_ = i32();
}
let _e14757 = phi_29348_;
continue;
continuing {
phi_29347_ = _e14757;
break if !(_e11583);
}
}
}
}
}
}
} else {
let _e14761 = global_1.member.member_1.member;
let _e14764 = global_1.member.member_1.member_1;
let _e14765 = bitcast<i32>(_e14761);
let _e14766 = bitcast<i32>(_e14764);
if _e453 {
phi_40551_ = type_23(_e14766, _e14765);
} else {
phi_40551_ = type_23(_e14765, _e14766);
}
let _e14770 = phi_40551_;
let _e14774 = f32((_e298 + 15i));
let _e14776 = select(_e14774, _e378, (_e378 < _e14774));
let _e14778 = select(_e314, _e14776, (_e14776 > _e314));
let _e14780 = select(_e14774, _e14778, (_e14778 < _e14774));
let _e14787 = select(0i, select(select(i32(_e14780), i32(-2147483648), (_e14780 < -2147483600f)), 2147483647i, (_e14780 > 2147483500f)), (_e14780 == _e14780));
let _e14791 = (_e14787 - select(0i, 1i, (_e14780 < f32(_e14787))));
let _e14792 = bitcast<i32>(_e14791);
let _e14794 = select(_e314, _e365, (_e365 > _e314));
let _e14796 = select(_e314, _e14794, (_e14794 > _e314));
let _e14798 = select(_e14774, _e14796, (_e14796 < _e14774));
let _e14805 = select(0i, select(select(i32(_e14798), i32(-2147483648), (_e14798 < -2147483600f)), 2147483647i, (_e14798 > 2147483500f)), (_e14798 == _e14798));
let _e14809 = (_e14805 - select(0i, 1i, (_e14798 < f32(_e14805))));
let _e14810 = bitcast<i32>(_e14809);
if (_e14792 < _e14770.member) {
phi_40626_ = _e14792;
} else {
phi_40626_ = (_e14770.member - 1i);
}
let _e14814 = phi_40626_;
let _e14815 = (_e14770.member_1 - 1i);
let _e14816 = (_e766 == 0u);
if _e14816 {
let _e14818 = select(_e847, 0u, (_e847 == _e766));
let _e14822 = select(_e927, 0u, ((_e927 == _e766) || (_e927 == _e847)));
let _e14830 = ((select(0u, 1u, (_e766 > 0u)) + select(0u, 1u, (_e14818 > 0u))) + select(0u, 1u, (_e14822 > 0u)));
if (_e14830 == 0u) {
phi_40664_ = 0i;
loop {
let _e14833 = phi_40664_;
let _e14834 = (_e14833 < 16i);
if _e14834 {
let _e14836 = (_e14810 + (_e14833 & 15i));
let _e14840 = (((f32(_e14836) + 0.5f) * 1f) - 0.5f);
let _e14844 = (-(((_e416 * _e14840) + _e442)) / _e429);
let _e14851 = bitcast<f32>((bitcast<u32>(((_e466 * _e14840) + ((_e479 * _e14844) + _e492))) & 2147483647u));
let _e14858 = bitcast<f32>((bitcast<u32>(((_e505 * _e14840) + ((_e518 * _e14844) + _e531))) & 2147483647u));
let _e14862 = (((0.5f * (_e14851 + _e14858)) / _e534) + _e717);
let _e14863 = (1f / 1f);
let _e14871 = ((((_e14844 + _e14862) + 0.5f) * _e14863) - 0.5f);
let _e14872 = f32(_e14815);
let _e14873 = (0f - 1f);
let _e14875 = select(_e14873, _e14871, (_e14871 > _e14873));
let _e14877 = select(_e14872, _e14875, (_e14875 < _e14872));
let _e14884 = select(0i, select(select(i32(_e14877), i32(-2147483648), (_e14877 < -2147483600f)), 2147483647i, (_e14877 > 2147483500f)), (_e14877 == _e14877));
let _e14889 = (((((_e14844 - _e14862) + 0.5f) * _e14863) - 0.5f) + 1f);
let _e14890 = (_e14872 + 1f);
let _e14892 = select(0f, _e14889, (_e14889 > 0f));
let _e14894 = select(_e14890, _e14892, (_e14892 < _e14890));
let _e14901 = select(0i, select(select(i32(_e14894), i32(-2147483648), (_e14894 < -2147483600f)), 2147483647i, (_e14894 > 2147483500f)), (_e14894 == _e14894));
let _e14912 = ((1e-4f * 1f) * _e534);
let _e14914 = select(_e14858, _e14851, (_e14851 > _e14858));
let _e14916 = select(_e14912, _e14914, (_e14914 > _e14912));
let _e14918 = select(_e14858, _e14851, (_e14851 < _e14858));
let _e14920 = select(_e14912, _e14918, (_e14918 > _e14912));
let _e14922 = (0.5f * (_e14916 + _e14920));
let _e14923 = (0.5f / _e14920);
let _e14924 = (1f / _e14916);
phi_40818_ = 0i;
loop {
let _e14926 = phi_40818_;
let _e14928 = (((_e14901 - select(0i, 1i, (_e14894 < f32(_e14901)))) + (_e14833 >> bitcast<u32>(4u))) + bitcast<i32>(_e14926));
let _e14929 = (_e14928 <= select(-1i, (_e14884 - select(0i, 1i, (_e14877 < f32(_e14884)))), (_e14836 <= _e14814)));
if _e14929 {
let _e14935 = (((((f32(_e14928) + 0.5f) * 1f) - 0.5f) - _e14844) * _e534);
let _e14936 = (_e534 * 1f);
let _e14938 = (0.5f * _e14936);
let _e14939 = (_e14935 + _e14938);
let _e14940 = -(_e14939);
let _e14943 = (_e14922 - select(_e14940, _e14939, (_e14939 > _e14940)));
let _e14945 = select(0f, _e14943, (_e14943 > 0f));
let _e14947 = select(_e14920, _e14945, (_e14945 < _e14920));
let _e14950 = (_e14943 - _e14920);
let _e14954 = (((_e14947 * (_e14947 * _e14923)) + select(0f, _e14950, (_e14950 > 0f))) * _e14924);
let _e14958 = (_e14935 - _e14938);
let _e14959 = -(_e14958);
let _e14962 = (_e14922 - select(_e14959, _e14958, (_e14958 > _e14959)));
let _e14964 = select(0f, _e14962, (_e14962 > 0f));
let _e14966 = select(_e14920, _e14964, (_e14964 < _e14920));
let _e14969 = (_e14962 - _e14920);
let _e14973 = (((_e14966 * (_e14966 * _e14923)) + select(0f, _e14969, (_e14969 > 0f))) * _e14924);
if _e453 {
phi_40923_ = type_23(_e14928, _e14836);
} else {
phi_40923_ = type_23(_e14836, _e14928);
}
let _e14982 = phi_40923_;
local_78 = bitcast<i32>((_e14761 * _e14764));
local_79 = ((_e14982.member_1 * _e14765) + _e14982.member);
let _e14989 = local_78;
let _e14990 = local_79;
let _e14991 = (_e14989 + _e14990);
let _e14993 = (bitcast<i32>(_e259) - 1i);
let _e14995 = select(_e14993, _e14991, (_e14991 < _e14993));
let _e15000 = global_5.member[bitcast<u32>(select(0i, _e14995, (_e14995 > 0i)))];
let _e15001 = local_79;
let _e15003 = select(_e14993, _e15001, (_e15001 < _e14993));
let _e15008 = global_5.member[bitcast<u32>(select(0i, _e15003, (_e15003 > 0i)))];
let _e15019 = global_1.member.member_2.member;
let _e15020 = (((((f32(_e14982.member) + 0.5f) / f32(_e14765)) * 2f) - 1f) * _e15019);
let _e15027 = global_1.member.member_2.member_1;
let _e15028 = ((1f - (((f32(_e14982.member_1) + 0.5f) / f32(_e14766)) * 2f)) * _e15027);
let _e15030 = global_1.member.member_3;
let _e15038 = global_1.member.member_4;
let _e15045 = ((_e15030.member * _e15020) + (_e15038.member * _e15028));
let _e15046 = ((_e15030.member_1 * _e15020) + (_e15038.member_1 * _e15028));
let _e15047 = ((_e15030.member_2 * _e15020) + (_e15038.member_2 * _e15028));
let _e15050 = global_1.member.member_2.member_3;
let _e15051 = (_e15050 != 0u);
let _e15053 = global_1.member.member_5;
let _e15060 = select((_e15053.member + _e15045), _e15053.member, _e15051);
let _e15061 = select((_e15053.member_1 + _e15046), _e15053.member_1, _e15051);
let _e15062 = select((_e15053.member_2 + _e15047), _e15053.member_2, _e15051);
let _e15064 = global_1.member.member_6;
let _e15078 = (((_e15060 * _e15060) + (_e15061 * _e15061)) + (_e15062 * _e15062));
let _e15081 = sqrt(select(0f, _e15078, (_e15078 > 0f)));
let _e15082 = (1f / _e15081);
let _e15083 = (_e15060 * _e15082);
let _e15084 = (_e15061 * _e15082);
let _e15085 = (_e15062 * _e15082);
let _e15086 = (_e575 - select(_e15064.member, (_e15064.member + _e15045), _e15051));
let _e15087 = (_e587 - select(_e15064.member_1, (_e15064.member_1 + _e15046), _e15051));
let _e15088 = (_e600 - select(_e15064.member_2, (_e15064.member_2 + _e15047), _e15051));
let _e15093 = (((_e15086 * _e15083) + (_e15087 * _e15084)) + (_e15088 * _e15085));
let _e15098 = (((_e15086 * _e613) + (_e15087 * _e626)) + (_e15088 * _e639));
let _e15103 = (((_e15083 * _e613) + (_e15084 * _e626)) + (_e15085 * _e639));
let _e15106 = ((_e15084 * _e639) - (_e15085 * _e626));
let _e15109 = ((_e15085 * _e613) - (_e15083 * _e639));
let _e15112 = ((_e15083 * _e626) - (_e15084 * _e613));
let _e15117 = (((_e15106 * _e15106) + (_e15109 * _e15109)) + (_e15112 * _e15112));
let _e15120 = (1f / select(1e-9f, _e15117, (_e15117 > 1e-9f)));
let _e15123 = ((_e15093 - (_e15103 * _e15098)) * _e15120);
let _e15126 = (((_e15103 * _e15093) - _e15098) * _e15120);
let _e15132 = -(_e15103);
let _e15135 = global_1.member.member_13.member_2;
let _e15136 = (_e15135 * _e15135);
let _e15140 = ((1f + _e15136) - ((2f * _e15135) * _e15132));
let _e15142 = select(1e-9f, _e15140, (_e15140 > 1e-9f));
let _e15154 = global_1.member.member_13.member_3;
if (_e15154 == 2u) {
let _e15159 = (0.5f - (0.5f * _e15132));
let _e15161 = select(0f, _e15159, (_e15159 > 0f));
let _e15165 = (sqrt(select(0f, _e15161, (_e15161 > 0f))) * 255f);
let _e15166 = (255f - 1f);
let _e15168 = select(0f, _e15165, (_e15165 > 0f));
let _e15170 = select(_e15166, _e15168, (_e15168 < _e15166));
let _e15177 = select(0i, select(select(i32(_e15170), i32(-2147483648), (_e15170 < -2147483600f)), 2147483647i, (_e15170 > 2147483500f)), (_e15170 == _e15170));
let _e15181 = (_e15177 - select(0i, 1i, (_e15170 < f32(_e15177))));
let _e15184 = global_1.member.member_13.member_11;
let _e15185 = bitcast<i32>(_e15184);
let _e15186 = (_e15185 + _e15181);
let _e15188 = (bitcast<i32>(_e265) - 1i);
let _e15190 = select(_e15188, _e15186, (_e15186 < _e15188));
let _e15195 = global_2.member[bitcast<u32>(select(0i, _e15190, (_e15190 > 0i)))];
let _e15197 = (_e15185 + (_e15181 + 1i));
let _e15199 = select(_e15188, _e15197, (_e15197 < _e15188));
let _e15204 = global_2.member[bitcast<u32>(select(0i, _e15199, (_e15199 > 0i)))];
phi_41350_ = (_e15195 + ((_e15204 - _e15195) * (_e15165 - f32(_e15181))));
} else {
phi_41350_ = select(((1f - _e15136) / (_e15142 * sqrt(select(0f, _e15142, (_e15142 > 0f))))), (0.75f * (1f + (_e15132 * _e15132))), (_e15154 == 1u));
}
let _e15211 = phi_41350_;
let _e15214 = (_e15081 * (_e15211 * (0.25f / 3.1415927f)));
let _e15215 = (_e15123 - _e15000);
let _e15218 = (_e15126 + select(0f, _e15215, (_e15215 > 0f)));
let _e15221 = global_1.member.member_13.member_1;
let _e15230 = global_1.member.member_13.member;
let _e15235 = -((_e15230.member * _e15218));
let _e15237 = select(-87f, _e15235, (_e15235 > -87f));
let _e15239 = select(88f, _e15237, (_e15237 < 88f));
let _e15241 = ((_e15239 * 1.442695f) + 0.5f);
let _e15243 = select(-127f, _e15241, (_e15241 > -127f));
let _e15245 = select(128f, _e15243, (_e15243 < 128f));
let _e15252 = select(0i, select(select(i32(_e15245), i32(-2147483648), (_e15245 < -2147483600f)), 2147483647i, (_e15245 > 2147483500f)), (_e15245 == _e15245));
let _e15256 = (_e15252 - select(0i, 1i, (_e15245 < f32(_e15252))));
let _e15257 = f32(_e15256);
let _e15261 = ((_e15239 - (_e15257 * 0.6933594f)) - (_e15257 * -2.1219444e-4f));
let _e15283 = -((_e15230.member_1 * _e15218));
let _e15285 = select(-87f, _e15283, (_e15283 > -87f));
let _e15287 = select(88f, _e15285, (_e15285 < 88f));
let _e15289 = ((_e15287 * 1.442695f) + 0.5f);
let _e15291 = select(-127f, _e15289, (_e15289 > -127f));
let _e15293 = select(128f, _e15291, (_e15291 < 128f));
let _e15300 = select(0i, select(select(i32(_e15293), i32(-2147483648), (_e15293 < -2147483600f)), 2147483647i, (_e15293 > 2147483500f)), (_e15293 == _e15293));
let _e15304 = (_e15300 - select(0i, 1i, (_e15293 < f32(_e15300))));
let _e15305 = f32(_e15304);
let _e15309 = ((_e15287 - (_e15305 * 0.6933594f)) - (_e15305 * -2.1219444e-4f));
let _e15331 = -((_e15230.member_2 * _e15218));
let _e15333 = select(-87f, _e15331, (_e15331 > -87f));
let _e15335 = select(88f, _e15333, (_e15333 < 88f));
let _e15337 = ((_e15335 * 1.442695f) + 0.5f);
let _e15339 = select(-127f, _e15337, (_e15337 > -127f));
let _e15341 = select(128f, _e15339, (_e15339 < 128f));
let _e15348 = select(0i, select(select(i32(_e15341), i32(-2147483648), (_e15341 < -2147483600f)), 2147483647i, (_e15341 > 2147483500f)), (_e15341 == _e15341));
let _e15352 = (_e15348 - select(0i, 1i, (_e15341 < f32(_e15348))));
let _e15353 = f32(_e15352);
let _e15357 = ((_e15335 - (_e15353 * 0.6933594f)) - (_e15353 * -2.1219444e-4f));
let _e15384 = select(0f, _e15123, (((_e15126 >= 0f) && (_e15126 < _e691)) && (_e15123 > 0f)));
if _e453 {
phi_41595_ = type_23(_e14928, _e14836);
} else {
phi_41595_ = type_23(_e14836, _e14928);
}
let _e15395 = phi_41595_;
let _e15398 = (_e14929 && (((_e15384 > 0f) && (_e15384 < _e15008)) && true));
let _e15401 = global_1.member.member_18.member;
let _e15402 = (((select(_e14954, (1f - _e14954), (_e14939 >= 0f)) - select(_e14973, (1f - _e14973), (_e14958 >= 0f))) * (1f / _e14936)) * _e15401);
let _e15406 = select(0f, (((((_e652 * _e15221.member) * ((1f + (_e15261 * (1f + (_e15261 * (0.5f + (_e15261 * (0.16666667f + (_e15261 * (0.041666668f + (_e15261 * (0.008333334f + (_e15261 * (0.001388889f + (_e15261 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e15256 + 127i)) << bitcast<u32>(23i))))) * _e15214) * 1f) * _e15402), _e15398);
let _e15407 = select(0f, (((((_e665 * _e15221.member_1) * ((1f + (_e15309 * (1f + (_e15309 * (0.5f + (_e15309 * (0.16666667f + (_e15309 * (0.041666668f + (_e15309 * (0.008333334f + (_e15309 * (0.001388889f + (_e15309 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e15304 + 127i)) << bitcast<u32>(23i))))) * _e15214) * 1f) * _e15402), _e15398);
let _e15408 = select(0f, (((((_e678 * _e15221.member_2) * ((1f + (_e15357 * (1f + (_e15357 * (0.5f + (_e15357 * (0.16666667f + (_e15357 * (0.041666668f + (_e15357 * (0.008333334f + (_e15357 * (0.001388889f + (_e15357 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e15352 + 127i)) << bitcast<u32>(23i))))) * _e15214) * 1f) * _e15402), _e15398);
let _e15412 = (bitcast<f32>((bitcast<u32>(_e15406) & 2147483647u)) >= 1073741800f);
let _e15413 = (1f / 1048576f);
let _e15416 = ((_e15406 * select(1f, _e15413, _e15412)) + 0.5f);
let _e15418 = select(-1073741800f, _e15416, (_e15416 > -1073741800f));
let _e15420 = select(1073741800f, _e15418, (_e15418 < 1073741800f));
let _e15427 = select(0i, select(select(i32(_e15420), i32(-2147483648), (_e15420 < -2147483600f)), 2147483647i, (_e15420 > 2147483500f)), (_e15420 == _e15420));
let _e15431 = (_e15427 - select(0i, 1i, (_e15420 < f32(_e15427))));
let _e15432 = select(0i, 20i, _e15412);
let _e15436 = (bitcast<u32>(_e15431) << bitcast<u32>((_e15432 & 31i)));
let _e15443 = bitcast<u32>(((_e15431 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e15432) & 31i))));
let _e15447 = (bitcast<f32>((bitcast<u32>(_e15407) & 2147483647u)) >= 1073741800f);
let _e15450 = ((_e15407 * select(1f, _e15413, _e15447)) + 0.5f);
let _e15452 = select(-1073741800f, _e15450, (_e15450 > -1073741800f));
let _e15454 = select(1073741800f, _e15452, (_e15452 < 1073741800f));
let _e15461 = select(0i, select(select(i32(_e15454), i32(-2147483648), (_e15454 < -2147483600f)), 2147483647i, (_e15454 > 2147483500f)), (_e15454 == _e15454));
let _e15465 = (_e15461 - select(0i, 1i, (_e15454 < f32(_e15461))));
let _e15466 = select(0i, 20i, _e15447);
let _e15470 = (bitcast<u32>(_e15465) << bitcast<u32>((_e15466 & 31i)));
let _e15477 = bitcast<u32>(((_e15465 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e15466) & 31i))));
let _e15481 = (bitcast<f32>((bitcast<u32>(_e15408) & 2147483647u)) >= 1073741800f);
let _e15484 = ((_e15408 * select(1f, _e15413, _e15481)) + 0.5f);
let _e15486 = select(-1073741800f, _e15484, (_e15484 > -1073741800f));
let _e15488 = select(1073741800f, _e15486, (_e15486 < 1073741800f));
let _e15495 = select(0i, select(select(i32(_e15488), i32(-2147483648), (_e15488 < -2147483600f)), 2147483647i, (_e15488 > 2147483500f)), (_e15488 == _e15488));
let _e15499 = (_e15495 - select(0i, 1i, (_e15488 < f32(_e15495))));
let _e15500 = select(0i, 20i, _e15481);
let _e15504 = (bitcast<u32>(_e15499) << bitcast<u32>((_e15500 & 31i)));
let _e15511 = bitcast<u32>(((_e15499 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e15500) & 31i))));
let _e15516 = bitcast<i32>(bitcast<u32>((((_e15395.member_1 * _e14765) + _e15395.member) * 6i)));
if ((_e15436 | _e15443) == 0u) {
} else {
let _e15519 = bitcast<u32>(_e15516);
if (_e15519 < _e270) {
let _e15523 = atomicAdd((&global_8.member[_e15519]), _e15436);
phi_41828_ = _e15523;
} else {
phi_41828_ = 0u;
}
let _e15525 = phi_41828_;
let _e15529 = (_e15443 + select(0u, 1u, ((_e15525 + _e15436) < _e15436)));
if (_e15529 == 0u) {
} else {
let _e15531 = (_e15519 + 1u);
if (_e15531 < _e270) {
let _e15535 = atomicAdd((&global_8.member[_e15531]), _e15529);
}
}
}
if ((_e15470 | _e15477) == 0u) {
} else {
let _e15539 = bitcast<u32>((_e15516 + 2i));
if (_e15539 < _e270) {
let _e15543 = atomicAdd((&global_8.member[_e15539]), _e15470);
phi_41858_ = _e15543;
} else {
phi_41858_ = 0u;
}
let _e15545 = phi_41858_;
let _e15549 = (_e15477 + select(0u, 1u, ((_e15545 + _e15470) < _e15470)));
if (_e15549 == 0u) {
} else {
let _e15551 = (_e15539 + 1u);
if (_e15551 < _e270) {
let _e15555 = atomicAdd((&global_8.member[_e15551]), _e15549);
}
}
}
if ((_e15504 | _e15511) == 0u) {
} else {
let _e15559 = bitcast<u32>((_e15516 + 4i));
if (_e15559 < _e270) {
let _e15563 = atomicAdd((&global_8.member[_e15559]), _e15504);
phi_41888_ = _e15563;
} else {
phi_41888_ = 0u;
}
let _e15565 = phi_41888_;
let _e15569 = (_e15511 + select(0u, 1u, ((_e15565 + _e15504) < _e15504)));
if (_e15569 == 0u) {
} else {
let _e15571 = (_e15559 + 1u);
if (_e15571 < _e270) {
let _e15575 = atomicAdd((&global_8.member[_e15571]), _e15569);
}
}
}
phi_40819_ = (_e14926 + 1i);
} else {
phi_40819_ = i32();
}
let _e15578 = phi_40819_;
continue;
continuing {
phi_40818_ = _e15578;
break if !(_e14929);
}
}
phi_40665_ = (_e14833 + 1i);
} else {
phi_40665_ = i32();
}
let _e15582 = phi_40665_;
continue;
continuing {
phi_40664_ = _e15582;
break if !(_e14834);
}
}
} else {
if (_e14830 == 1u) {
phi_41937_ = 0i;
loop {
let _e15586 = phi_41937_;
let _e15587 = (_e15586 < 16i);
if _e15587 {
let _e15589 = (_e14810 + (_e15586 & 15i));
let _e15591 = (f32(_e15589) + 0.5f);
let _e15593 = ((_e15591 * 1f) - 0.5f);
let _e15597 = (-(((_e416 * _e15593) + _e442)) / _e429);
let _e15604 = bitcast<f32>((bitcast<u32>(((_e466 * _e15593) + ((_e479 * _e15597) + _e492))) & 2147483647u));
let _e15611 = bitcast<f32>((bitcast<u32>(((_e505 * _e15593) + ((_e518 * _e15597) + _e531))) & 2147483647u));
let _e15615 = (((0.5f * (_e15604 + _e15611)) / _e534) + _e717);
let _e15616 = (1f / 1f);
let _e15624 = ((((_e15597 + _e15615) + 0.5f) * _e15616) - 0.5f);
let _e15625 = f32(_e14815);
let _e15626 = (0f - 1f);
let _e15628 = select(_e15626, _e15624, (_e15624 > _e15626));
let _e15630 = select(_e15625, _e15628, (_e15628 < _e15625));
let _e15637 = select(0i, select(select(i32(_e15630), i32(-2147483648), (_e15630 < -2147483600f)), 2147483647i, (_e15630 > 2147483500f)), (_e15630 == _e15630));
let _e15642 = (((((_e15597 - _e15615) + 0.5f) * _e15616) - 0.5f) + 1f);
let _e15643 = (_e15625 + 1f);
let _e15645 = select(0f, _e15642, (_e15642 > 0f));
let _e15647 = select(_e15643, _e15645, (_e15645 < _e15643));
let _e15654 = select(0i, select(select(i32(_e15647), i32(-2147483648), (_e15647 < -2147483600f)), 2147483647i, (_e15647 > 2147483500f)), (_e15647 == _e15647));
let _e15665 = ((1e-4f * 1f) * _e534);
let _e15667 = select(_e15611, _e15604, (_e15604 > _e15611));
let _e15669 = select(_e15665, _e15667, (_e15667 > _e15665));
let _e15671 = select(_e15611, _e15604, (_e15604 < _e15611));
let _e15673 = select(_e15665, _e15671, (_e15671 > _e15665));
let _e15675 = (0.5f * (_e15669 + _e15673));
let _e15676 = (0.5f / _e15673);
let _e15677 = (1f / _e15669);
phi_42091_ = 0i;
loop {
let _e15679 = phi_42091_;
let _e15681 = (((_e15654 - select(0i, 1i, (_e15647 < f32(_e15654)))) + (_e15586 >> bitcast<u32>(4u))) + bitcast<i32>(_e15679));
let _e15682 = (_e15681 <= select(-1i, (_e15637 - select(0i, 1i, (_e15630 < f32(_e15637)))), (_e15589 <= _e14814)));
if _e15682 {
let _e15684 = (f32(_e15681) + 0.5f);
let _e15688 = ((((_e15684 * 1f) - 0.5f) - _e15597) * _e534);
let _e15689 = (_e534 * 1f);
let _e15691 = (0.5f * _e15689);
let _e15692 = (_e15688 + _e15691);
let _e15693 = -(_e15692);
let _e15696 = (_e15675 - select(_e15693, _e15692, (_e15692 > _e15693)));
let _e15698 = select(0f, _e15696, (_e15696 > 0f));
let _e15700 = select(_e15673, _e15698, (_e15698 < _e15673));
let _e15703 = (_e15696 - _e15673);
let _e15707 = (((_e15700 * (_e15700 * _e15676)) + select(0f, _e15703, (_e15703 > 0f))) * _e15677);
let _e15711 = (_e15688 - _e15691);
let _e15712 = -(_e15711);
let _e15715 = (_e15675 - select(_e15712, _e15711, (_e15711 > _e15712)));
let _e15717 = select(0f, _e15715, (_e15715 > 0f));
let _e15719 = select(_e15673, _e15717, (_e15717 < _e15673));
let _e15722 = (_e15715 - _e15673);
let _e15726 = (((_e15719 * (_e15719 * _e15676)) + select(0f, _e15722, (_e15722 > 0f))) * _e15677);
if _e453 {
phi_42196_ = type_23(_e15681, _e15589);
} else {
phi_42196_ = type_23(_e15589, _e15681);
}
let _e15735 = phi_42196_;
local_76 = bitcast<i32>((_e14761 * _e14764));
local_77 = ((_e15735.member_1 * _e14765) + _e15735.member);
let _e15742 = local_76;
let _e15743 = local_77;
let _e15744 = (_e15742 + _e15743);
let _e15746 = (bitcast<i32>(_e259) - 1i);
let _e15748 = select(_e15746, _e15744, (_e15744 < _e15746));
let _e15753 = global_5.member[bitcast<u32>(select(0i, _e15748, (_e15748 > 0i)))];
let _e15754 = local_77;
let _e15756 = select(_e15746, _e15754, (_e15754 < _e15746));
let _e15761 = global_5.member[bitcast<u32>(select(0i, _e15756, (_e15756 > 0i)))];
let _e15764 = f32(_e14765);
let _e15765 = f32(_e14766);
let _e15772 = global_1.member.member_2.member;
let _e15773 = (((((f32(_e15735.member) + 0.5f) / _e15764) * 2f) - 1f) * _e15772);
let _e15780 = global_1.member.member_2.member_1;
let _e15781 = ((1f - (((f32(_e15735.member_1) + 0.5f) / _e15765) * 2f)) * _e15780);
let _e15783 = global_1.member.member_3;
let _e15791 = global_1.member.member_4;
let _e15798 = ((_e15783.member * _e15773) + (_e15791.member * _e15781));
let _e15799 = ((_e15783.member_1 * _e15773) + (_e15791.member_1 * _e15781));
let _e15800 = ((_e15783.member_2 * _e15773) + (_e15791.member_2 * _e15781));
let _e15803 = global_1.member.member_2.member_3;
let _e15804 = (_e15803 != 0u);
let _e15806 = global_1.member.member_5;
let _e15813 = select((_e15806.member + _e15798), _e15806.member, _e15804);
let _e15814 = select((_e15806.member_1 + _e15799), _e15806.member_1, _e15804);
let _e15815 = select((_e15806.member_2 + _e15800), _e15806.member_2, _e15804);
let _e15817 = global_1.member.member_6;
let _e15831 = (((_e15813 * _e15813) + (_e15814 * _e15814)) + (_e15815 * _e15815));
let _e15834 = sqrt(select(0f, _e15831, (_e15831 > 0f)));
let _e15835 = (1f / _e15834);
let _e15836 = (_e15813 * _e15835);
let _e15837 = (_e15814 * _e15835);
let _e15838 = (_e15815 * _e15835);
let _e15839 = (_e575 - select(_e15817.member, (_e15817.member + _e15798), _e15804));
let _e15840 = (_e587 - select(_e15817.member_1, (_e15817.member_1 + _e15799), _e15804));
let _e15841 = (_e600 - select(_e15817.member_2, (_e15817.member_2 + _e15800), _e15804));
let _e15846 = (((_e15839 * _e15836) + (_e15840 * _e15837)) + (_e15841 * _e15838));
let _e15851 = (((_e15839 * _e613) + (_e15840 * _e626)) + (_e15841 * _e639));
let _e15856 = (((_e15836 * _e613) + (_e15837 * _e626)) + (_e15838 * _e639));
let _e15859 = ((_e15837 * _e639) - (_e15838 * _e626));
let _e15862 = ((_e15838 * _e613) - (_e15836 * _e639));
let _e15865 = ((_e15836 * _e626) - (_e15837 * _e613));
let _e15870 = (((_e15859 * _e15859) + (_e15862 * _e15862)) + (_e15865 * _e15865));
let _e15873 = (1f / select(1e-9f, _e15870, (_e15870 > 1e-9f)));
let _e15876 = ((_e15846 - (_e15856 * _e15851)) * _e15873);
let _e15879 = (((_e15856 * _e15846) - _e15851) * _e15873);
let _e15885 = -(_e15856);
let _e15888 = global_1.member.member_13.member_2;
let _e15889 = (_e15888 * _e15888);
let _e15893 = ((1f + _e15889) - ((2f * _e15888) * _e15885));
let _e15895 = select(1e-9f, _e15893, (_e15893 > 1e-9f));
let _e15907 = global_1.member.member_13.member_3;
if (_e15907 == 2u) {
let _e15912 = (0.5f - (0.5f * _e15885));
let _e15914 = select(0f, _e15912, (_e15912 > 0f));
let _e15918 = (sqrt(select(0f, _e15914, (_e15914 > 0f))) * 255f);
let _e15919 = (255f - 1f);
let _e15921 = select(0f, _e15918, (_e15918 > 0f));
let _e15923 = select(_e15919, _e15921, (_e15921 < _e15919));
let _e15930 = select(0i, select(select(i32(_e15923), i32(-2147483648), (_e15923 < -2147483600f)), 2147483647i, (_e15923 > 2147483500f)), (_e15923 == _e15923));
let _e15934 = (_e15930 - select(0i, 1i, (_e15923 < f32(_e15930))));
let _e15937 = global_1.member.member_13.member_11;
let _e15938 = bitcast<i32>(_e15937);
let _e15939 = (_e15938 + _e15934);
let _e15941 = (bitcast<i32>(_e265) - 1i);
let _e15943 = select(_e15941, _e15939, (_e15939 < _e15941));
let _e15948 = global_2.member[bitcast<u32>(select(0i, _e15943, (_e15943 > 0i)))];
let _e15950 = (_e15938 + (_e15934 + 1i));
let _e15952 = select(_e15941, _e15950, (_e15950 < _e15941));
let _e15957 = global_2.member[bitcast<u32>(select(0i, _e15952, (_e15952 > 0i)))];
phi_42623_ = (_e15948 + ((_e15957 - _e15948) * (_e15918 - f32(_e15934))));
} else {
phi_42623_ = select(((1f - _e15889) / (_e15895 * sqrt(select(0f, _e15895, (_e15895 > 0f))))), (0.75f * (1f + (_e15885 * _e15885))), (_e15907 == 1u));
}
let _e15964 = phi_42623_;
let _e15967 = (_e15834 * (_e15964 * (0.25f / 3.1415927f)));
let _e15968 = (_e15876 - _e15753);
let _e15971 = (_e15879 + select(0f, _e15968, (_e15968 > 0f)));
let _e15974 = global_1.member.member_13.member_1;
let _e15983 = global_1.member.member_13.member;
let _e15988 = -((_e15983.member * _e15971));
let _e15990 = select(-87f, _e15988, (_e15988 > -87f));
let _e15992 = select(88f, _e15990, (_e15990 < 88f));
let _e15994 = ((_e15992 * 1.442695f) + 0.5f);
let _e15996 = select(-127f, _e15994, (_e15994 > -127f));
let _e15998 = select(128f, _e15996, (_e15996 < 128f));
let _e16005 = select(0i, select(select(i32(_e15998), i32(-2147483648), (_e15998 < -2147483600f)), 2147483647i, (_e15998 > 2147483500f)), (_e15998 == _e15998));
let _e16009 = (_e16005 - select(0i, 1i, (_e15998 < f32(_e16005))));
let _e16010 = f32(_e16009);
let _e16014 = ((_e15992 - (_e16010 * 0.6933594f)) - (_e16010 * -2.1219444e-4f));
let _e16036 = -((_e15983.member_1 * _e15971));
let _e16038 = select(-87f, _e16036, (_e16036 > -87f));
let _e16040 = select(88f, _e16038, (_e16038 < 88f));
let _e16042 = ((_e16040 * 1.442695f) + 0.5f);
let _e16044 = select(-127f, _e16042, (_e16042 > -127f));
let _e16046 = select(128f, _e16044, (_e16044 < 128f));
let _e16053 = select(0i, select(select(i32(_e16046), i32(-2147483648), (_e16046 < -2147483600f)), 2147483647i, (_e16046 > 2147483500f)), (_e16046 == _e16046));
let _e16057 = (_e16053 - select(0i, 1i, (_e16046 < f32(_e16053))));
let _e16058 = f32(_e16057);
let _e16062 = ((_e16040 - (_e16058 * 0.6933594f)) - (_e16058 * -2.1219444e-4f));
let _e16084 = -((_e15983.member_2 * _e15971));
let _e16086 = select(-87f, _e16084, (_e16084 > -87f));
let _e16088 = select(88f, _e16086, (_e16086 < 88f));
let _e16090 = ((_e16088 * 1.442695f) + 0.5f);
let _e16092 = select(-127f, _e16090, (_e16090 > -127f));
let _e16094 = select(128f, _e16092, (_e16092 < 128f));
let _e16101 = select(0i, select(select(i32(_e16094), i32(-2147483648), (_e16094 < -2147483600f)), 2147483647i, (_e16094 > 2147483500f)), (_e16094 == _e16094));
let _e16105 = (_e16101 - select(0i, 1i, (_e16094 < f32(_e16101))));
let _e16106 = f32(_e16105);
let _e16110 = ((_e16088 - (_e16106 * 0.6933594f)) - (_e16106 * -2.1219444e-4f));
let _e16137 = select(0f, _e15876, (((_e15879 >= 0f) && (_e15879 < _e691)) && (_e15876 > 0f)));
let _e16139 = ((_e766 + _e14818) + _e14822);
let _e16140 = (_e16139 & 31u);
let _e16142 = (1u << bitcast<u32>(_e16140));
let _e16151 = bitcast<i32>((((_e14761 + _e16142) - 1u) >> bitcast<u32>(_e16140)));
let _e16152 = bitcast<i32>((((_e14764 + _e16142) - 1u) >> bitcast<u32>(_e16140)));
if _e453 {
phi_42894_ = type_23(_e16152, _e16151);
} else {
phi_42894_ = type_23(_e16151, _e16152);
}
let _e16156 = phi_42894_;
let _e16161 = f32((1i << bitcast<u32>(_e16140)));
let _e16162 = (1f / _e16161);
let _e16164 = ((_e15591 * _e16162) - 0.5f);
let _e16166 = ((_e15684 * _e16162) - 0.5f);
let _e16168 = select(-1f, _e16164, (_e16164 > -1f));
let _e16170 = select(1e6f, _e16168, (_e16168 < 1e6f));
let _e16177 = select(0i, select(select(i32(_e16170), i32(-2147483648), (_e16170 < -2147483600f)), 2147483647i, (_e16170 > 2147483500f)), (_e16170 == _e16170));
let _e16181 = (_e16177 - select(0i, 1i, (_e16170 < f32(_e16177))));
let _e16183 = select(-1f, _e16166, (_e16166 > -1f));
let _e16185 = select(1e6f, _e16183, (_e16183 < 1e6f));
let _e16192 = select(0i, select(select(i32(_e16185), i32(-2147483648), (_e16185 < -2147483600f)), 2147483647i, (_e16185 > 2147483500f)), (_e16185 == _e16185));
let _e16196 = (_e16192 - select(0i, 1i, (_e16185 < f32(_e16192))));
let _e16198 = (_e16164 - f32(_e16181));
let _e16200 = (_e16166 - f32(_e16196));
let _e16201 = (1f - _e16198);
let _e16202 = (1f - _e16200);
let _e16205 = select(_e16181, 0i, (_e16181 < 0i));
let _e16206 = (_e16205 >= _e16156.member);
if _e16206 {
phi_42972_ = (_e16156.member - 1i);
} else {
phi_42972_ = _e16205;
}
let _e16209 = phi_42972_;
let _e16211 = select(_e16196, 0i, (_e16196 < 0i));
let _e16212 = (_e16211 >= _e16156.member_1);
if _e16212 {
phi_42983_ = (_e16156.member_1 - 1i);
} else {
phi_42983_ = _e16211;
}
let _e16215 = phi_42983_;
let _e16219 = (((f32(_e16209) + 0.5f) * _e16161) - 0.5f);
let _e16223 = (((f32(_e16215) + 0.5f) * _e16161) - 0.5f);
if _e453 {
phi_43011_ = type_23(_e16215, _e16209);
} else {
phi_43011_ = type_23(_e16209, _e16215);
}
let _e16229 = phi_43011_;
let _e16235 = bitcast<i32>(((_e14761 + 1u) >> bitcast<u32>(1u)));
let _e16238 = global_1.member.member_18.member_6;
let _e16241 = global_1.member.member_18.member_7;
let _e16244 = global_1.member.member_18.member_8;
let _e16245 = (_e16139 == 0u);
if _e16245 {
phi_43062_ = 0u;
} else {
if (_e16139 == 1u) {
phi_43061_ = 0u;
} else {
if (_e16139 == 2u) {
phi_43060_ = _e16238;
} else {
phi_43060_ = select(_e16244, _e16241, (_e16139 == 3u));
}
let _e16251 = phi_43060_;
phi_43061_ = _e16251;
}
let _e16253 = phi_43061_;
phi_43062_ = _e16253;
}
let _e16255 = phi_43062_;
local_74 = (((bitcast<i32>(_e16255) + _e16229.member_1) * _e16235) + _e16229.member);
let _e16260 = local_74;
let _e16262 = (bitcast<i32>(_e262) - 1i);
let _e16264 = select(_e16262, _e16260, (_e16260 < _e16262));
let _e16269 = global_6.member[bitcast<u32>(select(0i, _e16264, (_e16264 > 0i)))];
let _e16274 = (((((select(_e16219, _e16223, _e453) + 0.5f) / _e15764) * 2f) - 1f) * _e15772);
let _e16279 = ((1f - (((select(_e16223, _e16219, _e453) + 0.5f) / _e15765) * 2f)) * _e15780);
let _e16286 = ((_e15783.member * _e16274) + (_e15791.member * _e16279));
let _e16287 = ((_e15783.member_1 * _e16274) + (_e15791.member_1 * _e16279));
let _e16288 = ((_e15783.member_2 * _e16274) + (_e15791.member_2 * _e16279));
let _e16292 = select((_e15806.member + _e16286), _e15806.member, _e15804);
let _e16293 = select((_e15806.member_1 + _e16287), _e15806.member_1, _e15804);
let _e16294 = select((_e15806.member_2 + _e16288), _e15806.member_2, _e15804);
let _e16305 = (((_e16292 * _e16292) + (_e16293 * _e16293)) + (_e16294 * _e16294));
let _e16309 = (1f / sqrt(select(0f, _e16305, (_e16305 > 0f))));
let _e16310 = (_e16292 * _e16309);
let _e16311 = (_e16293 * _e16309);
let _e16312 = (_e16294 * _e16309);
let _e16313 = (_e575 - select(_e15817.member, (_e15817.member + _e16286), _e15804));
let _e16314 = (_e587 - select(_e15817.member_1, (_e15817.member_1 + _e16287), _e15804));
let _e16315 = (_e600 - select(_e15817.member_2, (_e15817.member_2 + _e16288), _e15804));
let _e16320 = (((_e16313 * _e16310) + (_e16314 * _e16311)) + (_e16315 * _e16312));
let _e16325 = (((_e16313 * _e613) + (_e16314 * _e626)) + (_e16315 * _e639));
let _e16330 = (((_e16310 * _e613) + (_e16311 * _e626)) + (_e16312 * _e639));
let _e16333 = ((_e16311 * _e639) - (_e16312 * _e626));
let _e16336 = ((_e16312 * _e613) - (_e16310 * _e639));
let _e16339 = ((_e16310 * _e626) - (_e16311 * _e613));
let _e16344 = (((_e16333 * _e16333) + (_e16336 * _e16336)) + (_e16339 * _e16339));
let _e16347 = (1f / select(1e-9f, _e16344, (_e16344 > 1e-9f)));
let _e16350 = ((_e16320 - (_e16330 * _e16325)) * _e16347);
let _e16353 = (((_e16330 * _e16320) - _e16325) * _e16347);
let _e16359 = select(0f, _e16350, (((_e16353 >= 0f) && (_e16353 < _e691)) && (_e16350 > 0f)));
let _e16361 = (_e16209 << bitcast<u32>(_e16140));
let _e16373 = (_e16181 + 1i);
let _e16376 = select(_e16373, 0i, (_e16373 < 0i));
let _e16377 = (_e16376 >= _e16156.member);
if _e16377 {
phi_43723_ = (_e16156.member - 1i);
} else {
phi_43723_ = _e16376;
}
let _e16380 = phi_43723_;
if _e16212 {
phi_43734_ = (_e16156.member_1 - 1i);
} else {
phi_43734_ = _e16211;
}
let _e16383 = phi_43734_;
let _e16387 = (((f32(_e16380) + 0.5f) * _e16161) - 0.5f);
let _e16391 = (((f32(_e16383) + 0.5f) * _e16161) - 0.5f);
if _e453 {
phi_43762_ = type_23(_e16383, _e16380);
} else {
phi_43762_ = type_23(_e16380, _e16383);
}
let _e16397 = phi_43762_;
if _e16245 {
phi_43813_ = 0u;
} else {
if (_e16139 == 1u) {
phi_43812_ = 0u;
} else {
if (_e16139 == 2u) {
phi_43811_ = _e16238;
} else {
phi_43811_ = select(_e16244, _e16241, (_e16139 == 3u));
}
let _e16405 = phi_43811_;
phi_43812_ = _e16405;
}
let _e16407 = phi_43812_;
phi_43813_ = _e16407;
}
let _e16409 = phi_43813_;
local_72 = (((bitcast<i32>(_e16409) + _e16397.member_1) * _e16235) + _e16397.member);
let _e16414 = local_72;
let _e16416 = select(_e16262, _e16414, (_e16414 < _e16262));
let _e16421 = global_6.member[bitcast<u32>(select(0i, _e16416, (_e16416 > 0i)))];
let _e16426 = (((((select(_e16387, _e16391, _e453) + 0.5f) / _e15764) * 2f) - 1f) * _e15772);
let _e16431 = ((1f - (((select(_e16391, _e16387, _e453) + 0.5f) / _e15765) * 2f)) * _e15780);
let _e16438 = ((_e15783.member * _e16426) + (_e15791.member * _e16431));
let _e16439 = ((_e15783.member_1 * _e16426) + (_e15791.member_1 * _e16431));
let _e16440 = ((_e15783.member_2 * _e16426) + (_e15791.member_2 * _e16431));
let _e16444 = select((_e15806.member + _e16438), _e15806.member, _e15804);
let _e16445 = select((_e15806.member_1 + _e16439), _e15806.member_1, _e15804);
let _e16446 = select((_e15806.member_2 + _e16440), _e15806.member_2, _e15804);
let _e16457 = (((_e16444 * _e16444) + (_e16445 * _e16445)) + (_e16446 * _e16446));
let _e16461 = (1f / sqrt(select(0f, _e16457, (_e16457 > 0f))));
let _e16462 = (_e16444 * _e16461);
let _e16463 = (_e16445 * _e16461);
let _e16464 = (_e16446 * _e16461);
let _e16465 = (_e575 - select(_e15817.member, (_e15817.member + _e16438), _e15804));
let _e16466 = (_e587 - select(_e15817.member_1, (_e15817.member_1 + _e16439), _e15804));
let _e16467 = (_e600 - select(_e15817.member_2, (_e15817.member_2 + _e16440), _e15804));
let _e16472 = (((_e16465 * _e16462) + (_e16466 * _e16463)) + (_e16467 * _e16464));
let _e16477 = (((_e16465 * _e613) + (_e16466 * _e626)) + (_e16467 * _e639));
let _e16482 = (((_e16462 * _e613) + (_e16463 * _e626)) + (_e16464 * _e639));
let _e16485 = ((_e16463 * _e639) - (_e16464 * _e626));
let _e16488 = ((_e16464 * _e613) - (_e16462 * _e639));
let _e16491 = ((_e16462 * _e626) - (_e16463 * _e613));
let _e16496 = (((_e16485 * _e16485) + (_e16488 * _e16488)) + (_e16491 * _e16491));
let _e16499 = (1f / select(1e-9f, _e16496, (_e16496 > 1e-9f)));
let _e16502 = ((_e16472 - (_e16482 * _e16477)) * _e16499);
let _e16505 = (((_e16482 * _e16472) - _e16477) * _e16499);
let _e16511 = select(0f, _e16502, (((_e16505 >= 0f) && (_e16505 < _e691)) && (_e16502 > 0f)));
let _e16513 = (_e16380 << bitcast<u32>(_e16140));
let _e16525 = (_e16196 + 1i);
if _e16206 {
phi_44474_ = (_e16156.member - 1i);
} else {
phi_44474_ = _e16205;
}
let _e16529 = phi_44474_;
let _e16531 = select(_e16525, 0i, (_e16525 < 0i));
let _e16532 = (_e16531 >= _e16156.member_1);
if _e16532 {
phi_44485_ = (_e16156.member_1 - 1i);
} else {
phi_44485_ = _e16531;
}
let _e16535 = phi_44485_;
let _e16539 = (((f32(_e16529) + 0.5f) * _e16161) - 0.5f);
let _e16543 = (((f32(_e16535) + 0.5f) * _e16161) - 0.5f);
if _e453 {
phi_44513_ = type_23(_e16535, _e16529);
} else {
phi_44513_ = type_23(_e16529, _e16535);
}
let _e16549 = phi_44513_;
if _e16245 {
phi_44564_ = 0u;
} else {
if (_e16139 == 1u) {
phi_44563_ = 0u;
} else {
if (_e16139 == 2u) {
phi_44562_ = _e16238;
} else {
phi_44562_ = select(_e16244, _e16241, (_e16139 == 3u));
}
let _e16557 = phi_44562_;
phi_44563_ = _e16557;
}
let _e16559 = phi_44563_;
phi_44564_ = _e16559;
}
let _e16561 = phi_44564_;
local_70 = (((bitcast<i32>(_e16561) + _e16549.member_1) * _e16235) + _e16549.member);
let _e16566 = local_70;
let _e16568 = select(_e16262, _e16566, (_e16566 < _e16262));
let _e16573 = global_6.member[bitcast<u32>(select(0i, _e16568, (_e16568 > 0i)))];
let _e16578 = (((((select(_e16539, _e16543, _e453) + 0.5f) / _e15764) * 2f) - 1f) * _e15772);
let _e16583 = ((1f - (((select(_e16543, _e16539, _e453) + 0.5f) / _e15765) * 2f)) * _e15780);
let _e16590 = ((_e15783.member * _e16578) + (_e15791.member * _e16583));
let _e16591 = ((_e15783.member_1 * _e16578) + (_e15791.member_1 * _e16583));
let _e16592 = ((_e15783.member_2 * _e16578) + (_e15791.member_2 * _e16583));
let _e16596 = select((_e15806.member + _e16590), _e15806.member, _e15804);
let _e16597 = select((_e15806.member_1 + _e16591), _e15806.member_1, _e15804);
let _e16598 = select((_e15806.member_2 + _e16592), _e15806.member_2, _e15804);
let _e16609 = (((_e16596 * _e16596) + (_e16597 * _e16597)) + (_e16598 * _e16598));
let _e16613 = (1f / sqrt(select(0f, _e16609, (_e16609 > 0f))));
let _e16614 = (_e16596 * _e16613);
let _e16615 = (_e16597 * _e16613);
let _e16616 = (_e16598 * _e16613);
let _e16617 = (_e575 - select(_e15817.member, (_e15817.member + _e16590), _e15804));
let _e16618 = (_e587 - select(_e15817.member_1, (_e15817.member_1 + _e16591), _e15804));
let _e16619 = (_e600 - select(_e15817.member_2, (_e15817.member_2 + _e16592), _e15804));
let _e16624 = (((_e16617 * _e16614) + (_e16618 * _e16615)) + (_e16619 * _e16616));
let _e16629 = (((_e16617 * _e613) + (_e16618 * _e626)) + (_e16619 * _e639));
let _e16634 = (((_e16614 * _e613) + (_e16615 * _e626)) + (_e16616 * _e639));
let _e16637 = ((_e16615 * _e639) - (_e16616 * _e626));
let _e16640 = ((_e16616 * _e613) - (_e16614 * _e639));
let _e16643 = ((_e16614 * _e626) - (_e16615 * _e613));
let _e16648 = (((_e16637 * _e16637) + (_e16640 * _e16640)) + (_e16643 * _e16643));
let _e16651 = (1f / select(1e-9f, _e16648, (_e16648 > 1e-9f)));
let _e16654 = ((_e16624 - (_e16634 * _e16629)) * _e16651);
let _e16657 = (((_e16634 * _e16624) - _e16629) * _e16651);
let _e16663 = select(0f, _e16654, (((_e16657 >= 0f) && (_e16657 < _e691)) && (_e16654 > 0f)));
let _e16665 = (_e16529 << bitcast<u32>(_e16140));
if _e16377 {
phi_45225_ = (_e16156.member - 1i);
} else {
phi_45225_ = _e16376;
}
let _e16680 = phi_45225_;
if _e16532 {
phi_45236_ = (_e16156.member_1 - 1i);
} else {
phi_45236_ = _e16531;
}
let _e16683 = phi_45236_;
let _e16687 = (((f32(_e16680) + 0.5f) * _e16161) - 0.5f);
let _e16691 = (((f32(_e16683) + 0.5f) * _e16161) - 0.5f);
if _e453 {
phi_45264_ = type_23(_e16683, _e16680);
} else {
phi_45264_ = type_23(_e16680, _e16683);
}
let _e16697 = phi_45264_;
if _e16245 {
phi_45315_ = 0u;
} else {
if (_e16139 == 1u) {
phi_45314_ = 0u;
} else {
if (_e16139 == 2u) {
phi_45313_ = _e16238;
} else {
phi_45313_ = select(_e16244, _e16241, (_e16139 == 3u));
}
let _e16705 = phi_45313_;
phi_45314_ = _e16705;
}
let _e16707 = phi_45314_;
phi_45315_ = _e16707;
}
let _e16709 = phi_45315_;
local_68 = (((bitcast<i32>(_e16709) + _e16697.member_1) * _e16235) + _e16697.member);
let _e16714 = local_68;
let _e16716 = select(_e16262, _e16714, (_e16714 < _e16262));
let _e16721 = global_6.member[bitcast<u32>(select(0i, _e16716, (_e16716 > 0i)))];
let _e16726 = (((((select(_e16687, _e16691, _e453) + 0.5f) / _e15764) * 2f) - 1f) * _e15772);
let _e16731 = ((1f - (((select(_e16691, _e16687, _e453) + 0.5f) / _e15765) * 2f)) * _e15780);
let _e16738 = ((_e15783.member * _e16726) + (_e15791.member * _e16731));
let _e16739 = ((_e15783.member_1 * _e16726) + (_e15791.member_1 * _e16731));
let _e16740 = ((_e15783.member_2 * _e16726) + (_e15791.member_2 * _e16731));
let _e16744 = select((_e15806.member + _e16738), _e15806.member, _e15804);
let _e16745 = select((_e15806.member_1 + _e16739), _e15806.member_1, _e15804);
let _e16746 = select((_e15806.member_2 + _e16740), _e15806.member_2, _e15804);
let _e16757 = (((_e16744 * _e16744) + (_e16745 * _e16745)) + (_e16746 * _e16746));
let _e16761 = (1f / sqrt(select(0f, _e16757, (_e16757 > 0f))));
let _e16762 = (_e16744 * _e16761);
let _e16763 = (_e16745 * _e16761);
let _e16764 = (_e16746 * _e16761);
let _e16765 = (_e575 - select(_e15817.member, (_e15817.member + _e16738), _e15804));
let _e16766 = (_e587 - select(_e15817.member_1, (_e15817.member_1 + _e16739), _e15804));
let _e16767 = (_e600 - select(_e15817.member_2, (_e15817.member_2 + _e16740), _e15804));
let _e16772 = (((_e16765 * _e16762) + (_e16766 * _e16763)) + (_e16767 * _e16764));
let _e16777 = (((_e16765 * _e613) + (_e16766 * _e626)) + (_e16767 * _e639));
let _e16782 = (((_e16762 * _e613) + (_e16763 * _e626)) + (_e16764 * _e639));
let _e16785 = ((_e16763 * _e639) - (_e16764 * _e626));
let _e16788 = ((_e16764 * _e613) - (_e16762 * _e639));
let _e16791 = ((_e16762 * _e626) - (_e16763 * _e613));
let _e16796 = (((_e16785 * _e16785) + (_e16788 * _e16788)) + (_e16791 * _e16791));
let _e16799 = (1f / select(1e-9f, _e16796, (_e16796 > 1e-9f)));
let _e16802 = ((_e16772 - (_e16782 * _e16777)) * _e16799);
let _e16805 = (((_e16782 * _e16772) - _e16777) * _e16799);
let _e16811 = select(0f, _e16802, (((_e16805 >= 0f) && (_e16805 < _e691)) && (_e16802 > 0f)));
let _e16813 = (_e16680 << bitcast<u32>(_e16140));
let _e16825 = select(((((1f - select(0f, (_e16201 * _e16202), (((select(select(_e766, _e927, (_e16361 >= _e692)), _e847, (_e16361 < _e298)) == _e16139) && (_e16359 > 0f)) && (_e16359 < _e16269)))) - select(0f, (_e16198 * _e16202), (((select(select(_e766, _e927, (_e16513 >= _e692)), _e847, (_e16513 < _e298)) == _e16139) && (_e16511 > 0f)) && (_e16511 < _e16421)))) - select(0f, (_e16201 * _e16200), (((select(select(_e766, _e927, (_e16665 >= _e692)), _e847, (_e16665 < _e298)) == _e16139) && (_e16663 > 0f)) && (_e16663 < _e16573)))) - select(0f, (_e16198 * _e16200), (((select(select(_e766, _e927, (_e16813 >= _e692)), _e847, (_e16813 < _e298)) == _e16139) && (_e16811 > 0f)) && (_e16811 < _e16721)))), 1f, _e16245);
if _e453 {
phi_45985_ = type_23(_e15681, _e15589);
} else {
phi_45985_ = type_23(_e15589, _e15681);
}
let _e16840 = phi_45985_;
let _e16843 = (_e15682 && (((_e16137 > 0f) && (_e16137 < _e15761)) && (bitcast<f32>((bitcast<u32>(_e16825) & 2147483647u)) > 1e-6f)));
let _e16846 = global_1.member.member_18.member;
let _e16847 = (((select(_e15707, (1f - _e15707), (_e15692 >= 0f)) - select(_e15726, (1f - _e15726), (_e15711 >= 0f))) * (1f / _e15689)) * _e16846);
let _e16851 = select(0f, (((((_e652 * _e15974.member) * ((1f + (_e16014 * (1f + (_e16014 * (0.5f + (_e16014 * (0.16666667f + (_e16014 * (0.041666668f + (_e16014 * (0.008333334f + (_e16014 * (0.001388889f + (_e16014 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e16009 + 127i)) << bitcast<u32>(23i))))) * _e15967) * _e16825) * _e16847), _e16843);
let _e16852 = select(0f, (((((_e665 * _e15974.member_1) * ((1f + (_e16062 * (1f + (_e16062 * (0.5f + (_e16062 * (0.16666667f + (_e16062 * (0.041666668f + (_e16062 * (0.008333334f + (_e16062 * (0.001388889f + (_e16062 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e16057 + 127i)) << bitcast<u32>(23i))))) * _e15967) * _e16825) * _e16847), _e16843);
let _e16853 = select(0f, (((((_e678 * _e15974.member_2) * ((1f + (_e16110 * (1f + (_e16110 * (0.5f + (_e16110 * (0.16666667f + (_e16110 * (0.041666668f + (_e16110 * (0.008333334f + (_e16110 * (0.001388889f + (_e16110 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e16105 + 127i)) << bitcast<u32>(23i))))) * _e15967) * _e16825) * _e16847), _e16843);
let _e16857 = (bitcast<f32>((bitcast<u32>(_e16851) & 2147483647u)) >= 1073741800f);
let _e16858 = (1f / 1048576f);
let _e16861 = ((_e16851 * select(1f, _e16858, _e16857)) + 0.5f);
let _e16863 = select(-1073741800f, _e16861, (_e16861 > -1073741800f));
let _e16865 = select(1073741800f, _e16863, (_e16863 < 1073741800f));
let _e16872 = select(0i, select(select(i32(_e16865), i32(-2147483648), (_e16865 < -2147483600f)), 2147483647i, (_e16865 > 2147483500f)), (_e16865 == _e16865));
let _e16876 = (_e16872 - select(0i, 1i, (_e16865 < f32(_e16872))));
let _e16877 = select(0i, 20i, _e16857);
let _e16881 = (bitcast<u32>(_e16876) << bitcast<u32>((_e16877 & 31i)));
let _e16888 = bitcast<u32>(((_e16876 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16877) & 31i))));
let _e16892 = (bitcast<f32>((bitcast<u32>(_e16852) & 2147483647u)) >= 1073741800f);
let _e16895 = ((_e16852 * select(1f, _e16858, _e16892)) + 0.5f);
let _e16897 = select(-1073741800f, _e16895, (_e16895 > -1073741800f));
let _e16899 = select(1073741800f, _e16897, (_e16897 < 1073741800f));
let _e16906 = select(0i, select(select(i32(_e16899), i32(-2147483648), (_e16899 < -2147483600f)), 2147483647i, (_e16899 > 2147483500f)), (_e16899 == _e16899));
let _e16910 = (_e16906 - select(0i, 1i, (_e16899 < f32(_e16906))));
let _e16911 = select(0i, 20i, _e16892);
let _e16915 = (bitcast<u32>(_e16910) << bitcast<u32>((_e16911 & 31i)));
let _e16922 = bitcast<u32>(((_e16910 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16911) & 31i))));
let _e16926 = (bitcast<f32>((bitcast<u32>(_e16853) & 2147483647u)) >= 1073741800f);
let _e16929 = ((_e16853 * select(1f, _e16858, _e16926)) + 0.5f);
let _e16931 = select(-1073741800f, _e16929, (_e16929 > -1073741800f));
let _e16933 = select(1073741800f, _e16931, (_e16931 < 1073741800f));
let _e16940 = select(0i, select(select(i32(_e16933), i32(-2147483648), (_e16933 < -2147483600f)), 2147483647i, (_e16933 > 2147483500f)), (_e16933 == _e16933));
let _e16944 = (_e16940 - select(0i, 1i, (_e16933 < f32(_e16940))));
let _e16945 = select(0i, 20i, _e16926);
let _e16949 = (bitcast<u32>(_e16944) << bitcast<u32>((_e16945 & 31i)));
let _e16956 = bitcast<u32>(((_e16944 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16945) & 31i))));
let _e16961 = bitcast<i32>(bitcast<u32>((((_e16840.member_1 * _e14765) + _e16840.member) * 6i)));
if ((_e16881 | _e16888) == 0u) {
} else {
let _e16964 = bitcast<u32>(_e16961);
if (_e16964 < _e270) {
let _e16968 = atomicAdd((&global_8.member[_e16964]), _e16881);
phi_46218_ = _e16968;
} else {
phi_46218_ = 0u;
}
let _e16970 = phi_46218_;
let _e16974 = (_e16888 + select(0u, 1u, ((_e16970 + _e16881) < _e16881)));
if (_e16974 == 0u) {
} else {
let _e16976 = (_e16964 + 1u);
if (_e16976 < _e270) {
let _e16980 = atomicAdd((&global_8.member[_e16976]), _e16974);
}
}
}
if ((_e16915 | _e16922) == 0u) {
} else {
let _e16984 = bitcast<u32>((_e16961 + 2i));
if (_e16984 < _e270) {
let _e16988 = atomicAdd((&global_8.member[_e16984]), _e16915);
phi_46248_ = _e16988;
} else {
phi_46248_ = 0u;
}
let _e16990 = phi_46248_;
let _e16994 = (_e16922 + select(0u, 1u, ((_e16990 + _e16915) < _e16915)));
if (_e16994 == 0u) {
} else {
let _e16996 = (_e16984 + 1u);
if (_e16996 < _e270) {
let _e17000 = atomicAdd((&global_8.member[_e16996]), _e16994);
}
}
}
if ((_e16949 | _e16956) == 0u) {
} else {
let _e17004 = bitcast<u32>((_e16961 + 4i));
if (_e17004 < _e270) {
let _e17008 = atomicAdd((&global_8.member[_e17004]), _e16949);
phi_46278_ = _e17008;
} else {
phi_46278_ = 0u;
}
let _e17010 = phi_46278_;
let _e17014 = (_e16956 + select(0u, 1u, ((_e17010 + _e16949) < _e16949)));
if (_e17014 == 0u) {
} else {
let _e17016 = (_e17004 + 1u);
if (_e17016 < _e270) {
let _e17020 = atomicAdd((&global_8.member[_e17016]), _e17014);
}
}
}
phi_42092_ = (_e15679 + 1i);
} else {
phi_42092_ = i32();
}
let _e17023 = phi_42092_;
continue;
continuing {
phi_42091_ = _e17023;
break if !(_e15682);
}
}
phi_41938_ = (_e15586 + 1i);
} else {
phi_41938_ = i32();
}
let _e17027 = phi_41938_;
continue;
continuing {
phi_41937_ = _e17027;
break if !(_e15587);
}
}
} else {
phi_46323_ = 0i;
loop {
let _e17030 = phi_46323_;
let _e17031 = (_e17030 < 16i);
if _e17031 {
let _e17033 = (_e14810 + (_e17030 & 15i));
let _e17035 = (f32(_e17033) + 0.5f);
let _e17037 = ((_e17035 * 1f) - 0.5f);
let _e17041 = (-(((_e416 * _e17037) + _e442)) / _e429);
let _e17048 = bitcast<f32>((bitcast<u32>(((_e466 * _e17037) + ((_e479 * _e17041) + _e492))) & 2147483647u));
let _e17055 = bitcast<f32>((bitcast<u32>(((_e505 * _e17037) + ((_e518 * _e17041) + _e531))) & 2147483647u));
let _e17059 = (((0.5f * (_e17048 + _e17055)) / _e534) + _e717);
let _e17060 = (1f / 1f);
let _e17068 = ((((_e17041 + _e17059) + 0.5f) * _e17060) - 0.5f);
let _e17069 = f32(_e14815);
let _e17070 = (0f - 1f);
let _e17072 = select(_e17070, _e17068, (_e17068 > _e17070));
let _e17074 = select(_e17069, _e17072, (_e17072 < _e17069));
let _e17081 = select(0i, select(select(i32(_e17074), i32(-2147483648), (_e17074 < -2147483600f)), 2147483647i, (_e17074 > 2147483500f)), (_e17074 == _e17074));
let _e17086 = (((((_e17041 - _e17059) + 0.5f) * _e17060) - 0.5f) + 1f);
let _e17087 = (_e17069 + 1f);
let _e17089 = select(0f, _e17086, (_e17086 > 0f));
let _e17091 = select(_e17087, _e17089, (_e17089 < _e17087));
let _e17098 = select(0i, select(select(i32(_e17091), i32(-2147483648), (_e17091 < -2147483600f)), 2147483647i, (_e17091 > 2147483500f)), (_e17091 == _e17091));
let _e17109 = ((1e-4f * 1f) * _e534);
let _e17111 = select(_e17055, _e17048, (_e17048 > _e17055));
let _e17113 = select(_e17109, _e17111, (_e17111 > _e17109));
let _e17115 = select(_e17055, _e17048, (_e17048 < _e17055));
let _e17117 = select(_e17109, _e17115, (_e17115 > _e17109));
let _e17119 = (0.5f * (_e17113 + _e17117));
let _e17120 = (0.5f / _e17117);
let _e17121 = (1f / _e17113);
phi_46477_ = 0i;
loop {
let _e17123 = phi_46477_;
let _e17125 = (((_e17098 - select(0i, 1i, (_e17091 < f32(_e17098)))) + (_e17030 >> bitcast<u32>(4u))) + bitcast<i32>(_e17123));
let _e17126 = (_e17125 <= select(-1i, (_e17081 - select(0i, 1i, (_e17074 < f32(_e17081)))), (_e17033 <= _e14814)));
if _e17126 {
let _e17128 = (f32(_e17125) + 0.5f);
let _e17132 = ((((_e17128 * 1f) - 0.5f) - _e17041) * _e534);
let _e17133 = (_e534 * 1f);
let _e17135 = (0.5f * _e17133);
let _e17136 = (_e17132 + _e17135);
let _e17137 = -(_e17136);
let _e17140 = (_e17119 - select(_e17137, _e17136, (_e17136 > _e17137)));
let _e17142 = select(0f, _e17140, (_e17140 > 0f));
let _e17144 = select(_e17117, _e17142, (_e17142 < _e17117));
let _e17147 = (_e17140 - _e17117);
let _e17151 = (((_e17144 * (_e17144 * _e17120)) + select(0f, _e17147, (_e17147 > 0f))) * _e17121);
let _e17155 = (_e17132 - _e17135);
let _e17156 = -(_e17155);
let _e17159 = (_e17119 - select(_e17156, _e17155, (_e17155 > _e17156)));
let _e17161 = select(0f, _e17159, (_e17159 > 0f));
let _e17163 = select(_e17117, _e17161, (_e17161 < _e17117));
let _e17166 = (_e17159 - _e17117);
let _e17170 = (((_e17163 * (_e17163 * _e17120)) + select(0f, _e17166, (_e17166 > 0f))) * _e17121);
if _e453 {
phi_46582_ = type_23(_e17125, _e17033);
} else {
phi_46582_ = type_23(_e17033, _e17125);
}
let _e17179 = phi_46582_;
local_66 = bitcast<i32>((_e14761 * _e14764));
local_67 = ((_e17179.member_1 * _e14765) + _e17179.member);
let _e17186 = local_66;
let _e17187 = local_67;
let _e17188 = (_e17186 + _e17187);
let _e17190 = (bitcast<i32>(_e259) - 1i);
let _e17192 = select(_e17190, _e17188, (_e17188 < _e17190));
let _e17197 = global_5.member[bitcast<u32>(select(0i, _e17192, (_e17192 > 0i)))];
let _e17198 = local_67;
let _e17200 = select(_e17190, _e17198, (_e17198 < _e17190));
let _e17205 = global_5.member[bitcast<u32>(select(0i, _e17200, (_e17200 > 0i)))];
let _e17208 = f32(_e14765);
let _e17209 = f32(_e14766);
let _e17216 = global_1.member.member_2.member;
let _e17217 = (((((f32(_e17179.member) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e17224 = global_1.member.member_2.member_1;
let _e17225 = ((1f - (((f32(_e17179.member_1) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e17227 = global_1.member.member_3;
let _e17235 = global_1.member.member_4;
let _e17242 = ((_e17227.member * _e17217) + (_e17235.member * _e17225));
let _e17243 = ((_e17227.member_1 * _e17217) + (_e17235.member_1 * _e17225));
let _e17244 = ((_e17227.member_2 * _e17217) + (_e17235.member_2 * _e17225));
let _e17247 = global_1.member.member_2.member_3;
let _e17248 = (_e17247 != 0u);
let _e17250 = global_1.member.member_5;
let _e17257 = select((_e17250.member + _e17242), _e17250.member, _e17248);
let _e17258 = select((_e17250.member_1 + _e17243), _e17250.member_1, _e17248);
let _e17259 = select((_e17250.member_2 + _e17244), _e17250.member_2, _e17248);
let _e17261 = global_1.member.member_6;
let _e17275 = (((_e17257 * _e17257) + (_e17258 * _e17258)) + (_e17259 * _e17259));
let _e17278 = sqrt(select(0f, _e17275, (_e17275 > 0f)));
let _e17279 = (1f / _e17278);
let _e17280 = (_e17257 * _e17279);
let _e17281 = (_e17258 * _e17279);
let _e17282 = (_e17259 * _e17279);
let _e17283 = (_e575 - select(_e17261.member, (_e17261.member + _e17242), _e17248));
let _e17284 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e17243), _e17248));
let _e17285 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e17244), _e17248));
let _e17290 = (((_e17283 * _e17280) + (_e17284 * _e17281)) + (_e17285 * _e17282));
let _e17295 = (((_e17283 * _e613) + (_e17284 * _e626)) + (_e17285 * _e639));
let _e17300 = (((_e17280 * _e613) + (_e17281 * _e626)) + (_e17282 * _e639));
let _e17303 = ((_e17281 * _e639) - (_e17282 * _e626));
let _e17306 = ((_e17282 * _e613) - (_e17280 * _e639));
let _e17309 = ((_e17280 * _e626) - (_e17281 * _e613));
let _e17314 = (((_e17303 * _e17303) + (_e17306 * _e17306)) + (_e17309 * _e17309));
let _e17317 = (1f / select(1e-9f, _e17314, (_e17314 > 1e-9f)));
let _e17320 = ((_e17290 - (_e17300 * _e17295)) * _e17317);
let _e17323 = (((_e17300 * _e17290) - _e17295) * _e17317);
let _e17329 = -(_e17300);
let _e17332 = global_1.member.member_13.member_2;
let _e17333 = (_e17332 * _e17332);
let _e17337 = ((1f + _e17333) - ((2f * _e17332) * _e17329));
let _e17339 = select(1e-9f, _e17337, (_e17337 > 1e-9f));
let _e17351 = global_1.member.member_13.member_3;
if (_e17351 == 2u) {
let _e17356 = (0.5f - (0.5f * _e17329));
let _e17358 = select(0f, _e17356, (_e17356 > 0f));
let _e17362 = (sqrt(select(0f, _e17358, (_e17358 > 0f))) * 255f);
let _e17363 = (255f - 1f);
let _e17365 = select(0f, _e17362, (_e17362 > 0f));
let _e17367 = select(_e17363, _e17365, (_e17365 < _e17363));
let _e17374 = select(0i, select(select(i32(_e17367), i32(-2147483648), (_e17367 < -2147483600f)), 2147483647i, (_e17367 > 2147483500f)), (_e17367 == _e17367));
let _e17378 = (_e17374 - select(0i, 1i, (_e17367 < f32(_e17374))));
let _e17381 = global_1.member.member_13.member_11;
let _e17382 = bitcast<i32>(_e17381);
let _e17383 = (_e17382 + _e17378);
let _e17385 = (bitcast<i32>(_e265) - 1i);
let _e17387 = select(_e17385, _e17383, (_e17383 < _e17385));
let _e17392 = global_2.member[bitcast<u32>(select(0i, _e17387, (_e17387 > 0i)))];
let _e17394 = (_e17382 + (_e17378 + 1i));
let _e17396 = select(_e17385, _e17394, (_e17394 < _e17385));
let _e17401 = global_2.member[bitcast<u32>(select(0i, _e17396, (_e17396 > 0i)))];
phi_47009_ = (_e17392 + ((_e17401 - _e17392) * (_e17362 - f32(_e17378))));
} else {
phi_47009_ = select(((1f - _e17333) / (_e17339 * sqrt(select(0f, _e17339, (_e17339 > 0f))))), (0.75f * (1f + (_e17329 * _e17329))), (_e17351 == 1u));
}
let _e17408 = phi_47009_;
let _e17411 = (_e17278 * (_e17408 * (0.25f / 3.1415927f)));
let _e17412 = (_e17320 - _e17197);
let _e17415 = (_e17323 + select(0f, _e17412, (_e17412 > 0f)));
let _e17418 = global_1.member.member_13.member_1;
let _e17427 = global_1.member.member_13.member;
let _e17432 = -((_e17427.member * _e17415));
let _e17434 = select(-87f, _e17432, (_e17432 > -87f));
let _e17436 = select(88f, _e17434, (_e17434 < 88f));
let _e17438 = ((_e17436 * 1.442695f) + 0.5f);
let _e17440 = select(-127f, _e17438, (_e17438 > -127f));
let _e17442 = select(128f, _e17440, (_e17440 < 128f));
let _e17449 = select(0i, select(select(i32(_e17442), i32(-2147483648), (_e17442 < -2147483600f)), 2147483647i, (_e17442 > 2147483500f)), (_e17442 == _e17442));
let _e17453 = (_e17449 - select(0i, 1i, (_e17442 < f32(_e17449))));
let _e17454 = f32(_e17453);
let _e17458 = ((_e17436 - (_e17454 * 0.6933594f)) - (_e17454 * -2.1219444e-4f));
let _e17480 = -((_e17427.member_1 * _e17415));
let _e17482 = select(-87f, _e17480, (_e17480 > -87f));
let _e17484 = select(88f, _e17482, (_e17482 < 88f));
let _e17486 = ((_e17484 * 1.442695f) + 0.5f);
let _e17488 = select(-127f, _e17486, (_e17486 > -127f));
let _e17490 = select(128f, _e17488, (_e17488 < 128f));
let _e17497 = select(0i, select(select(i32(_e17490), i32(-2147483648), (_e17490 < -2147483600f)), 2147483647i, (_e17490 > 2147483500f)), (_e17490 == _e17490));
let _e17501 = (_e17497 - select(0i, 1i, (_e17490 < f32(_e17497))));
let _e17502 = f32(_e17501);
let _e17506 = ((_e17484 - (_e17502 * 0.6933594f)) - (_e17502 * -2.1219444e-4f));
let _e17528 = -((_e17427.member_2 * _e17415));
let _e17530 = select(-87f, _e17528, (_e17528 > -87f));
let _e17532 = select(88f, _e17530, (_e17530 < 88f));
let _e17534 = ((_e17532 * 1.442695f) + 0.5f);
let _e17536 = select(-127f, _e17534, (_e17534 > -127f));
let _e17538 = select(128f, _e17536, (_e17536 < 128f));
let _e17545 = select(0i, select(select(i32(_e17538), i32(-2147483648), (_e17538 < -2147483600f)), 2147483647i, (_e17538 > 2147483500f)), (_e17538 == _e17538));
let _e17549 = (_e17545 - select(0i, 1i, (_e17538 < f32(_e17545))));
let _e17550 = f32(_e17549);
let _e17554 = ((_e17532 - (_e17550 * 0.6933594f)) - (_e17550 * -2.1219444e-4f));
let _e17581 = select(0f, _e17320, (((_e17323 >= 0f) && (_e17323 < _e691)) && (_e17320 > 0f)));
let _e17582 = (_e766 & 31u);
let _e17584 = (1u << bitcast<u32>(_e17582));
let _e17593 = bitcast<i32>((((_e14761 + _e17584) - 1u) >> bitcast<u32>(_e17582)));
let _e17594 = bitcast<i32>((((_e14764 + _e17584) - 1u) >> bitcast<u32>(_e17582)));
if _e453 {
phi_47278_ = type_23(_e17594, _e17593);
} else {
phi_47278_ = type_23(_e17593, _e17594);
}
let _e17598 = phi_47278_;
let _e17603 = f32((1i << bitcast<u32>(_e17582)));
let _e17604 = (1f / _e17603);
let _e17606 = ((_e17035 * _e17604) - 0.5f);
let _e17608 = ((_e17128 * _e17604) - 0.5f);
let _e17610 = select(-1f, _e17606, (_e17606 > -1f));
let _e17612 = select(1e6f, _e17610, (_e17610 < 1e6f));
let _e17619 = select(0i, select(select(i32(_e17612), i32(-2147483648), (_e17612 < -2147483600f)), 2147483647i, (_e17612 > 2147483500f)), (_e17612 == _e17612));
let _e17623 = (_e17619 - select(0i, 1i, (_e17612 < f32(_e17619))));
let _e17625 = select(-1f, _e17608, (_e17608 > -1f));
let _e17627 = select(1e6f, _e17625, (_e17625 < 1e6f));
let _e17634 = select(0i, select(select(i32(_e17627), i32(-2147483648), (_e17627 < -2147483600f)), 2147483647i, (_e17627 > 2147483500f)), (_e17627 == _e17627));
let _e17638 = (_e17634 - select(0i, 1i, (_e17627 < f32(_e17634))));
let _e17640 = (_e17606 - f32(_e17623));
let _e17642 = (_e17608 - f32(_e17638));
let _e17643 = (1f - _e17640);
let _e17644 = (1f - _e17642);
let _e17647 = select(_e17623, 0i, (_e17623 < 0i));
let _e17648 = (_e17647 >= _e17598.member);
if _e17648 {
phi_47356_ = (_e17598.member - 1i);
} else {
phi_47356_ = _e17647;
}
let _e17651 = phi_47356_;
let _e17653 = select(_e17638, 0i, (_e17638 < 0i));
let _e17654 = (_e17653 >= _e17598.member_1);
if _e17654 {
phi_47367_ = (_e17598.member_1 - 1i);
} else {
phi_47367_ = _e17653;
}
let _e17657 = phi_47367_;
let _e17661 = (((f32(_e17651) + 0.5f) * _e17603) - 0.5f);
let _e17665 = (((f32(_e17657) + 0.5f) * _e17603) - 0.5f);
if _e453 {
phi_47395_ = type_23(_e17657, _e17651);
} else {
phi_47395_ = type_23(_e17651, _e17657);
}
let _e17671 = phi_47395_;
let _e17677 = bitcast<i32>(((_e14761 + 1u) >> bitcast<u32>(1u)));
let _e17680 = global_1.member.member_18.member_6;
let _e17683 = global_1.member.member_18.member_7;
let _e17686 = global_1.member.member_18.member_8;
if _e14816 {
phi_47446_ = 0u;
} else {
if (_e766 == 1u) {
phi_47445_ = 0u;
} else {
if (_e766 == 2u) {
phi_47444_ = _e17680;
} else {
phi_47444_ = select(_e17686, _e17683, (_e766 == 3u));
}
let _e17692 = phi_47444_;
phi_47445_ = _e17692;
}
let _e17694 = phi_47445_;
phi_47446_ = _e17694;
}
let _e17696 = phi_47446_;
local_64 = (((bitcast<i32>(_e17696) + _e17671.member_1) * _e17677) + _e17671.member);
let _e17701 = local_64;
let _e17703 = (bitcast<i32>(_e262) - 1i);
let _e17705 = select(_e17703, _e17701, (_e17701 < _e17703));
let _e17710 = global_6.member[bitcast<u32>(select(0i, _e17705, (_e17705 > 0i)))];
let _e17715 = (((((select(_e17661, _e17665, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e17720 = ((1f - (((select(_e17665, _e17661, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e17727 = ((_e17227.member * _e17715) + (_e17235.member * _e17720));
let _e17728 = ((_e17227.member_1 * _e17715) + (_e17235.member_1 * _e17720));
let _e17729 = ((_e17227.member_2 * _e17715) + (_e17235.member_2 * _e17720));
let _e17733 = select((_e17250.member + _e17727), _e17250.member, _e17248);
let _e17734 = select((_e17250.member_1 + _e17728), _e17250.member_1, _e17248);
let _e17735 = select((_e17250.member_2 + _e17729), _e17250.member_2, _e17248);
let _e17746 = (((_e17733 * _e17733) + (_e17734 * _e17734)) + (_e17735 * _e17735));
let _e17750 = (1f / sqrt(select(0f, _e17746, (_e17746 > 0f))));
let _e17751 = (_e17733 * _e17750);
let _e17752 = (_e17734 * _e17750);
let _e17753 = (_e17735 * _e17750);
let _e17754 = (_e575 - select(_e17261.member, (_e17261.member + _e17727), _e17248));
let _e17755 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e17728), _e17248));
let _e17756 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e17729), _e17248));
let _e17761 = (((_e17754 * _e17751) + (_e17755 * _e17752)) + (_e17756 * _e17753));
let _e17766 = (((_e17754 * _e613) + (_e17755 * _e626)) + (_e17756 * _e639));
let _e17771 = (((_e17751 * _e613) + (_e17752 * _e626)) + (_e17753 * _e639));
let _e17774 = ((_e17752 * _e639) - (_e17753 * _e626));
let _e17777 = ((_e17753 * _e613) - (_e17751 * _e639));
let _e17780 = ((_e17751 * _e626) - (_e17752 * _e613));
let _e17785 = (((_e17774 * _e17774) + (_e17777 * _e17777)) + (_e17780 * _e17780));
let _e17788 = (1f / select(1e-9f, _e17785, (_e17785 > 1e-9f)));
let _e17791 = ((_e17761 - (_e17771 * _e17766)) * _e17788);
let _e17794 = (((_e17771 * _e17761) - _e17766) * _e17788);
let _e17800 = select(0f, _e17791, (((_e17794 >= 0f) && (_e17794 < _e691)) && (_e17791 > 0f)));
let _e17802 = (_e17651 << bitcast<u32>(_e17582));
let _e17814 = (_e17623 + 1i);
let _e17817 = select(_e17814, 0i, (_e17814 < 0i));
let _e17818 = (_e17817 >= _e17598.member);
if _e17818 {
phi_48107_ = (_e17598.member - 1i);
} else {
phi_48107_ = _e17817;
}
let _e17821 = phi_48107_;
if _e17654 {
phi_48118_ = (_e17598.member_1 - 1i);
} else {
phi_48118_ = _e17653;
}
let _e17824 = phi_48118_;
let _e17828 = (((f32(_e17821) + 0.5f) * _e17603) - 0.5f);
let _e17832 = (((f32(_e17824) + 0.5f) * _e17603) - 0.5f);
if _e453 {
phi_48146_ = type_23(_e17824, _e17821);
} else {
phi_48146_ = type_23(_e17821, _e17824);
}
let _e17838 = phi_48146_;
if _e14816 {
phi_48197_ = 0u;
} else {
if (_e766 == 1u) {
phi_48196_ = 0u;
} else {
if (_e766 == 2u) {
phi_48195_ = _e17680;
} else {
phi_48195_ = select(_e17686, _e17683, (_e766 == 3u));
}
let _e17846 = phi_48195_;
phi_48196_ = _e17846;
}
let _e17848 = phi_48196_;
phi_48197_ = _e17848;
}
let _e17850 = phi_48197_;
local_62 = (((bitcast<i32>(_e17850) + _e17838.member_1) * _e17677) + _e17838.member);
let _e17855 = local_62;
let _e17857 = select(_e17703, _e17855, (_e17855 < _e17703));
let _e17862 = global_6.member[bitcast<u32>(select(0i, _e17857, (_e17857 > 0i)))];
let _e17867 = (((((select(_e17828, _e17832, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e17872 = ((1f - (((select(_e17832, _e17828, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e17879 = ((_e17227.member * _e17867) + (_e17235.member * _e17872));
let _e17880 = ((_e17227.member_1 * _e17867) + (_e17235.member_1 * _e17872));
let _e17881 = ((_e17227.member_2 * _e17867) + (_e17235.member_2 * _e17872));
let _e17885 = select((_e17250.member + _e17879), _e17250.member, _e17248);
let _e17886 = select((_e17250.member_1 + _e17880), _e17250.member_1, _e17248);
let _e17887 = select((_e17250.member_2 + _e17881), _e17250.member_2, _e17248);
let _e17898 = (((_e17885 * _e17885) + (_e17886 * _e17886)) + (_e17887 * _e17887));
let _e17902 = (1f / sqrt(select(0f, _e17898, (_e17898 > 0f))));
let _e17903 = (_e17885 * _e17902);
let _e17904 = (_e17886 * _e17902);
let _e17905 = (_e17887 * _e17902);
let _e17906 = (_e575 - select(_e17261.member, (_e17261.member + _e17879), _e17248));
let _e17907 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e17880), _e17248));
let _e17908 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e17881), _e17248));
let _e17913 = (((_e17906 * _e17903) + (_e17907 * _e17904)) + (_e17908 * _e17905));
let _e17918 = (((_e17906 * _e613) + (_e17907 * _e626)) + (_e17908 * _e639));
let _e17923 = (((_e17903 * _e613) + (_e17904 * _e626)) + (_e17905 * _e639));
let _e17926 = ((_e17904 * _e639) - (_e17905 * _e626));
let _e17929 = ((_e17905 * _e613) - (_e17903 * _e639));
let _e17932 = ((_e17903 * _e626) - (_e17904 * _e613));
let _e17937 = (((_e17926 * _e17926) + (_e17929 * _e17929)) + (_e17932 * _e17932));
let _e17940 = (1f / select(1e-9f, _e17937, (_e17937 > 1e-9f)));
let _e17943 = ((_e17913 - (_e17923 * _e17918)) * _e17940);
let _e17946 = (((_e17923 * _e17913) - _e17918) * _e17940);
let _e17952 = select(0f, _e17943, (((_e17946 >= 0f) && (_e17946 < _e691)) && (_e17943 > 0f)));
let _e17954 = (_e17821 << bitcast<u32>(_e17582));
let _e17966 = (_e17638 + 1i);
if _e17648 {
phi_48858_ = (_e17598.member - 1i);
} else {
phi_48858_ = _e17647;
}
let _e17970 = phi_48858_;
let _e17972 = select(_e17966, 0i, (_e17966 < 0i));
let _e17973 = (_e17972 >= _e17598.member_1);
if _e17973 {
phi_48869_ = (_e17598.member_1 - 1i);
} else {
phi_48869_ = _e17972;
}
let _e17976 = phi_48869_;
let _e17980 = (((f32(_e17970) + 0.5f) * _e17603) - 0.5f);
let _e17984 = (((f32(_e17976) + 0.5f) * _e17603) - 0.5f);
if _e453 {
phi_48897_ = type_23(_e17976, _e17970);
} else {
phi_48897_ = type_23(_e17970, _e17976);
}
let _e17990 = phi_48897_;
if _e14816 {
phi_48948_ = 0u;
} else {
if (_e766 == 1u) {
phi_48947_ = 0u;
} else {
if (_e766 == 2u) {
phi_48946_ = _e17680;
} else {
phi_48946_ = select(_e17686, _e17683, (_e766 == 3u));
}
let _e17998 = phi_48946_;
phi_48947_ = _e17998;
}
let _e18000 = phi_48947_;
phi_48948_ = _e18000;
}
let _e18002 = phi_48948_;
local_60 = (((bitcast<i32>(_e18002) + _e17990.member_1) * _e17677) + _e17990.member);
let _e18007 = local_60;
let _e18009 = select(_e17703, _e18007, (_e18007 < _e17703));
let _e18014 = global_6.member[bitcast<u32>(select(0i, _e18009, (_e18009 > 0i)))];
let _e18019 = (((((select(_e17980, _e17984, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e18024 = ((1f - (((select(_e17984, _e17980, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e18031 = ((_e17227.member * _e18019) + (_e17235.member * _e18024));
let _e18032 = ((_e17227.member_1 * _e18019) + (_e17235.member_1 * _e18024));
let _e18033 = ((_e17227.member_2 * _e18019) + (_e17235.member_2 * _e18024));
let _e18037 = select((_e17250.member + _e18031), _e17250.member, _e17248);
let _e18038 = select((_e17250.member_1 + _e18032), _e17250.member_1, _e17248);
let _e18039 = select((_e17250.member_2 + _e18033), _e17250.member_2, _e17248);
let _e18050 = (((_e18037 * _e18037) + (_e18038 * _e18038)) + (_e18039 * _e18039));
let _e18054 = (1f / sqrt(select(0f, _e18050, (_e18050 > 0f))));
let _e18055 = (_e18037 * _e18054);
let _e18056 = (_e18038 * _e18054);
let _e18057 = (_e18039 * _e18054);
let _e18058 = (_e575 - select(_e17261.member, (_e17261.member + _e18031), _e17248));
let _e18059 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e18032), _e17248));
let _e18060 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e18033), _e17248));
let _e18065 = (((_e18058 * _e18055) + (_e18059 * _e18056)) + (_e18060 * _e18057));
let _e18070 = (((_e18058 * _e613) + (_e18059 * _e626)) + (_e18060 * _e639));
let _e18075 = (((_e18055 * _e613) + (_e18056 * _e626)) + (_e18057 * _e639));
let _e18078 = ((_e18056 * _e639) - (_e18057 * _e626));
let _e18081 = ((_e18057 * _e613) - (_e18055 * _e639));
let _e18084 = ((_e18055 * _e626) - (_e18056 * _e613));
let _e18089 = (((_e18078 * _e18078) + (_e18081 * _e18081)) + (_e18084 * _e18084));
let _e18092 = (1f / select(1e-9f, _e18089, (_e18089 > 1e-9f)));
let _e18095 = ((_e18065 - (_e18075 * _e18070)) * _e18092);
let _e18098 = (((_e18075 * _e18065) - _e18070) * _e18092);
let _e18104 = select(0f, _e18095, (((_e18098 >= 0f) && (_e18098 < _e691)) && (_e18095 > 0f)));
let _e18106 = (_e17970 << bitcast<u32>(_e17582));
if _e17818 {
phi_49609_ = (_e17598.member - 1i);
} else {
phi_49609_ = _e17817;
}
let _e18121 = phi_49609_;
if _e17973 {
phi_49620_ = (_e17598.member_1 - 1i);
} else {
phi_49620_ = _e17972;
}
let _e18124 = phi_49620_;
let _e18128 = (((f32(_e18121) + 0.5f) * _e17603) - 0.5f);
let _e18132 = (((f32(_e18124) + 0.5f) * _e17603) - 0.5f);
if _e453 {
phi_49648_ = type_23(_e18124, _e18121);
} else {
phi_49648_ = type_23(_e18121, _e18124);
}
let _e18138 = phi_49648_;
if _e14816 {
phi_49699_ = 0u;
} else {
if (_e766 == 1u) {
phi_49698_ = 0u;
} else {
if (_e766 == 2u) {
phi_49697_ = _e17680;
} else {
phi_49697_ = select(_e17686, _e17683, (_e766 == 3u));
}
let _e18146 = phi_49697_;
phi_49698_ = _e18146;
}
let _e18148 = phi_49698_;
phi_49699_ = _e18148;
}
let _e18150 = phi_49699_;
local_58 = (((bitcast<i32>(_e18150) + _e18138.member_1) * _e17677) + _e18138.member);
let _e18155 = local_58;
let _e18157 = select(_e17703, _e18155, (_e18155 < _e17703));
let _e18162 = global_6.member[bitcast<u32>(select(0i, _e18157, (_e18157 > 0i)))];
let _e18167 = (((((select(_e18128, _e18132, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e18172 = ((1f - (((select(_e18132, _e18128, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e18179 = ((_e17227.member * _e18167) + (_e17235.member * _e18172));
let _e18180 = ((_e17227.member_1 * _e18167) + (_e17235.member_1 * _e18172));
let _e18181 = ((_e17227.member_2 * _e18167) + (_e17235.member_2 * _e18172));
let _e18185 = select((_e17250.member + _e18179), _e17250.member, _e17248);
let _e18186 = select((_e17250.member_1 + _e18180), _e17250.member_1, _e17248);
let _e18187 = select((_e17250.member_2 + _e18181), _e17250.member_2, _e17248);
let _e18198 = (((_e18185 * _e18185) + (_e18186 * _e18186)) + (_e18187 * _e18187));
let _e18202 = (1f / sqrt(select(0f, _e18198, (_e18198 > 0f))));
let _e18203 = (_e18185 * _e18202);
let _e18204 = (_e18186 * _e18202);
let _e18205 = (_e18187 * _e18202);
let _e18206 = (_e575 - select(_e17261.member, (_e17261.member + _e18179), _e17248));
let _e18207 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e18180), _e17248));
let _e18208 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e18181), _e17248));
let _e18213 = (((_e18206 * _e18203) + (_e18207 * _e18204)) + (_e18208 * _e18205));
let _e18218 = (((_e18206 * _e613) + (_e18207 * _e626)) + (_e18208 * _e639));
let _e18223 = (((_e18203 * _e613) + (_e18204 * _e626)) + (_e18205 * _e639));
let _e18226 = ((_e18204 * _e639) - (_e18205 * _e626));
let _e18229 = ((_e18205 * _e613) - (_e18203 * _e639));
let _e18232 = ((_e18203 * _e626) - (_e18204 * _e613));
let _e18237 = (((_e18226 * _e18226) + (_e18229 * _e18229)) + (_e18232 * _e18232));
let _e18240 = (1f / select(1e-9f, _e18237, (_e18237 > 1e-9f)));
let _e18243 = ((_e18213 - (_e18223 * _e18218)) * _e18240);
let _e18246 = (((_e18223 * _e18213) - _e18218) * _e18240);
let _e18252 = select(0f, _e18243, (((_e18246 >= 0f) && (_e18246 < _e691)) && (_e18243 > 0f)));
let _e18254 = (_e18121 << bitcast<u32>(_e17582));
let _e18266 = select(((((1f - select(0f, (_e17643 * _e17644), (((select(select(_e766, _e927, (_e17802 >= _e692)), _e847, (_e17802 < _e298)) == _e766) && (_e17800 > 0f)) && (_e17800 < _e17710)))) - select(0f, (_e17640 * _e17644), (((select(select(_e766, _e927, (_e17954 >= _e692)), _e847, (_e17954 < _e298)) == _e766) && (_e17952 > 0f)) && (_e17952 < _e17862)))) - select(0f, (_e17643 * _e17642), (((select(select(_e766, _e927, (_e18106 >= _e692)), _e847, (_e18106 < _e298)) == _e766) && (_e18104 > 0f)) && (_e18104 < _e18014)))) - select(0f, (_e17640 * _e17642), (((select(select(_e766, _e927, (_e18254 >= _e692)), _e847, (_e18254 < _e298)) == _e766) && (_e18252 > 0f)) && (_e18252 < _e18162)))), 1f, _e14816);
let _e18267 = (_e14818 & 31u);
let _e18269 = (1u << bitcast<u32>(_e18267));
let _e18278 = bitcast<i32>((((_e14761 + _e18269) - 1u) >> bitcast<u32>(_e18267)));
let _e18279 = bitcast<i32>((((_e14764 + _e18269) - 1u) >> bitcast<u32>(_e18267)));
if _e453 {
phi_50378_ = type_23(_e18279, _e18278);
} else {
phi_50378_ = type_23(_e18278, _e18279);
}
let _e18283 = phi_50378_;
let _e18288 = f32((1i << bitcast<u32>(_e18267)));
let _e18289 = (1f / _e18288);
let _e18291 = ((_e17035 * _e18289) - 0.5f);
let _e18293 = ((_e17128 * _e18289) - 0.5f);
let _e18295 = select(-1f, _e18291, (_e18291 > -1f));
let _e18297 = select(1e6f, _e18295, (_e18295 < 1e6f));
let _e18304 = select(0i, select(select(i32(_e18297), i32(-2147483648), (_e18297 < -2147483600f)), 2147483647i, (_e18297 > 2147483500f)), (_e18297 == _e18297));
let _e18308 = (_e18304 - select(0i, 1i, (_e18297 < f32(_e18304))));
let _e18310 = select(-1f, _e18293, (_e18293 > -1f));
let _e18312 = select(1e6f, _e18310, (_e18310 < 1e6f));
let _e18319 = select(0i, select(select(i32(_e18312), i32(-2147483648), (_e18312 < -2147483600f)), 2147483647i, (_e18312 > 2147483500f)), (_e18312 == _e18312));
let _e18323 = (_e18319 - select(0i, 1i, (_e18312 < f32(_e18319))));
let _e18325 = (_e18291 - f32(_e18308));
let _e18327 = (_e18293 - f32(_e18323));
let _e18328 = (1f - _e18325);
let _e18329 = (1f - _e18327);
let _e18332 = select(_e18308, 0i, (_e18308 < 0i));
let _e18333 = (_e18332 >= _e18283.member);
if _e18333 {
phi_50456_ = (_e18283.member - 1i);
} else {
phi_50456_ = _e18332;
}
let _e18336 = phi_50456_;
let _e18338 = select(_e18323, 0i, (_e18323 < 0i));
let _e18339 = (_e18338 >= _e18283.member_1);
if _e18339 {
phi_50467_ = (_e18283.member_1 - 1i);
} else {
phi_50467_ = _e18338;
}
let _e18342 = phi_50467_;
let _e18346 = (((f32(_e18336) + 0.5f) * _e18288) - 0.5f);
let _e18350 = (((f32(_e18342) + 0.5f) * _e18288) - 0.5f);
if _e453 {
phi_50495_ = type_23(_e18342, _e18336);
} else {
phi_50495_ = type_23(_e18336, _e18342);
}
let _e18356 = phi_50495_;
let _e18359 = (_e14818 == 0u);
if _e18359 {
phi_50546_ = 0u;
} else {
if (_e14818 == 1u) {
phi_50545_ = 0u;
} else {
if (_e14818 == 2u) {
phi_50544_ = _e17680;
} else {
phi_50544_ = select(_e17686, _e17683, (_e14818 == 3u));
}
let _e18365 = phi_50544_;
phi_50545_ = _e18365;
}
let _e18367 = phi_50545_;
phi_50546_ = _e18367;
}
let _e18369 = phi_50546_;
local_56 = (((bitcast<i32>(_e18369) + _e18356.member_1) * _e17677) + _e18356.member);
let _e18374 = local_56;
let _e18376 = select(_e17703, _e18374, (_e18374 < _e17703));
let _e18381 = global_6.member[bitcast<u32>(select(0i, _e18376, (_e18376 > 0i)))];
let _e18386 = (((((select(_e18346, _e18350, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e18391 = ((1f - (((select(_e18350, _e18346, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e18398 = ((_e17227.member * _e18386) + (_e17235.member * _e18391));
let _e18399 = ((_e17227.member_1 * _e18386) + (_e17235.member_1 * _e18391));
let _e18400 = ((_e17227.member_2 * _e18386) + (_e17235.member_2 * _e18391));
let _e18404 = select((_e17250.member + _e18398), _e17250.member, _e17248);
let _e18405 = select((_e17250.member_1 + _e18399), _e17250.member_1, _e17248);
let _e18406 = select((_e17250.member_2 + _e18400), _e17250.member_2, _e17248);
let _e18417 = (((_e18404 * _e18404) + (_e18405 * _e18405)) + (_e18406 * _e18406));
let _e18421 = (1f / sqrt(select(0f, _e18417, (_e18417 > 0f))));
let _e18422 = (_e18404 * _e18421);
let _e18423 = (_e18405 * _e18421);
let _e18424 = (_e18406 * _e18421);
let _e18425 = (_e575 - select(_e17261.member, (_e17261.member + _e18398), _e17248));
let _e18426 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e18399), _e17248));
let _e18427 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e18400), _e17248));
let _e18432 = (((_e18425 * _e18422) + (_e18426 * _e18423)) + (_e18427 * _e18424));
let _e18437 = (((_e18425 * _e613) + (_e18426 * _e626)) + (_e18427 * _e639));
let _e18442 = (((_e18422 * _e613) + (_e18423 * _e626)) + (_e18424 * _e639));
let _e18445 = ((_e18423 * _e639) - (_e18424 * _e626));
let _e18448 = ((_e18424 * _e613) - (_e18422 * _e639));
let _e18451 = ((_e18422 * _e626) - (_e18423 * _e613));
let _e18456 = (((_e18445 * _e18445) + (_e18448 * _e18448)) + (_e18451 * _e18451));
let _e18459 = (1f / select(1e-9f, _e18456, (_e18456 > 1e-9f)));
let _e18462 = ((_e18432 - (_e18442 * _e18437)) * _e18459);
let _e18465 = (((_e18442 * _e18432) - _e18437) * _e18459);
let _e18471 = select(0f, _e18462, (((_e18465 >= 0f) && (_e18465 < _e691)) && (_e18462 > 0f)));
let _e18473 = (_e18336 << bitcast<u32>(_e18267));
let _e18485 = (_e18308 + 1i);
let _e18488 = select(_e18485, 0i, (_e18485 < 0i));
let _e18489 = (_e18488 >= _e18283.member);
if _e18489 {
phi_51207_ = (_e18283.member - 1i);
} else {
phi_51207_ = _e18488;
}
let _e18492 = phi_51207_;
if _e18339 {
phi_51218_ = (_e18283.member_1 - 1i);
} else {
phi_51218_ = _e18338;
}
let _e18495 = phi_51218_;
let _e18499 = (((f32(_e18492) + 0.5f) * _e18288) - 0.5f);
let _e18503 = (((f32(_e18495) + 0.5f) * _e18288) - 0.5f);
if _e453 {
phi_51246_ = type_23(_e18495, _e18492);
} else {
phi_51246_ = type_23(_e18492, _e18495);
}
let _e18509 = phi_51246_;
if _e18359 {
phi_51297_ = 0u;
} else {
if (_e14818 == 1u) {
phi_51296_ = 0u;
} else {
if (_e14818 == 2u) {
phi_51295_ = _e17680;
} else {
phi_51295_ = select(_e17686, _e17683, (_e14818 == 3u));
}
let _e18517 = phi_51295_;
phi_51296_ = _e18517;
}
let _e18519 = phi_51296_;
phi_51297_ = _e18519;
}
let _e18521 = phi_51297_;
local_54 = (((bitcast<i32>(_e18521) + _e18509.member_1) * _e17677) + _e18509.member);
let _e18526 = local_54;
let _e18528 = select(_e17703, _e18526, (_e18526 < _e17703));
let _e18533 = global_6.member[bitcast<u32>(select(0i, _e18528, (_e18528 > 0i)))];
let _e18538 = (((((select(_e18499, _e18503, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e18543 = ((1f - (((select(_e18503, _e18499, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e18550 = ((_e17227.member * _e18538) + (_e17235.member * _e18543));
let _e18551 = ((_e17227.member_1 * _e18538) + (_e17235.member_1 * _e18543));
let _e18552 = ((_e17227.member_2 * _e18538) + (_e17235.member_2 * _e18543));
let _e18556 = select((_e17250.member + _e18550), _e17250.member, _e17248);
let _e18557 = select((_e17250.member_1 + _e18551), _e17250.member_1, _e17248);
let _e18558 = select((_e17250.member_2 + _e18552), _e17250.member_2, _e17248);
let _e18569 = (((_e18556 * _e18556) + (_e18557 * _e18557)) + (_e18558 * _e18558));
let _e18573 = (1f / sqrt(select(0f, _e18569, (_e18569 > 0f))));
let _e18574 = (_e18556 * _e18573);
let _e18575 = (_e18557 * _e18573);
let _e18576 = (_e18558 * _e18573);
let _e18577 = (_e575 - select(_e17261.member, (_e17261.member + _e18550), _e17248));
let _e18578 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e18551), _e17248));
let _e18579 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e18552), _e17248));
let _e18584 = (((_e18577 * _e18574) + (_e18578 * _e18575)) + (_e18579 * _e18576));
let _e18589 = (((_e18577 * _e613) + (_e18578 * _e626)) + (_e18579 * _e639));
let _e18594 = (((_e18574 * _e613) + (_e18575 * _e626)) + (_e18576 * _e639));
let _e18597 = ((_e18575 * _e639) - (_e18576 * _e626));
let _e18600 = ((_e18576 * _e613) - (_e18574 * _e639));
let _e18603 = ((_e18574 * _e626) - (_e18575 * _e613));
let _e18608 = (((_e18597 * _e18597) + (_e18600 * _e18600)) + (_e18603 * _e18603));
let _e18611 = (1f / select(1e-9f, _e18608, (_e18608 > 1e-9f)));
let _e18614 = ((_e18584 - (_e18594 * _e18589)) * _e18611);
let _e18617 = (((_e18594 * _e18584) - _e18589) * _e18611);
let _e18623 = select(0f, _e18614, (((_e18617 >= 0f) && (_e18617 < _e691)) && (_e18614 > 0f)));
let _e18625 = (_e18492 << bitcast<u32>(_e18267));
let _e18637 = (_e18323 + 1i);
if _e18333 {
phi_51958_ = (_e18283.member - 1i);
} else {
phi_51958_ = _e18332;
}
let _e18641 = phi_51958_;
let _e18643 = select(_e18637, 0i, (_e18637 < 0i));
let _e18644 = (_e18643 >= _e18283.member_1);
if _e18644 {
phi_51969_ = (_e18283.member_1 - 1i);
} else {
phi_51969_ = _e18643;
}
let _e18647 = phi_51969_;
let _e18651 = (((f32(_e18641) + 0.5f) * _e18288) - 0.5f);
let _e18655 = (((f32(_e18647) + 0.5f) * _e18288) - 0.5f);
if _e453 {
phi_51997_ = type_23(_e18647, _e18641);
} else {
phi_51997_ = type_23(_e18641, _e18647);
}
let _e18661 = phi_51997_;
if _e18359 {
phi_52048_ = 0u;
} else {
if (_e14818 == 1u) {
phi_52047_ = 0u;
} else {
if (_e14818 == 2u) {
phi_52046_ = _e17680;
} else {
phi_52046_ = select(_e17686, _e17683, (_e14818 == 3u));
}
let _e18669 = phi_52046_;
phi_52047_ = _e18669;
}
let _e18671 = phi_52047_;
phi_52048_ = _e18671;
}
let _e18673 = phi_52048_;
local_52 = (((bitcast<i32>(_e18673) + _e18661.member_1) * _e17677) + _e18661.member);
let _e18678 = local_52;
let _e18680 = select(_e17703, _e18678, (_e18678 < _e17703));
let _e18685 = global_6.member[bitcast<u32>(select(0i, _e18680, (_e18680 > 0i)))];
let _e18690 = (((((select(_e18651, _e18655, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e18695 = ((1f - (((select(_e18655, _e18651, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e18702 = ((_e17227.member * _e18690) + (_e17235.member * _e18695));
let _e18703 = ((_e17227.member_1 * _e18690) + (_e17235.member_1 * _e18695));
let _e18704 = ((_e17227.member_2 * _e18690) + (_e17235.member_2 * _e18695));
let _e18708 = select((_e17250.member + _e18702), _e17250.member, _e17248);
let _e18709 = select((_e17250.member_1 + _e18703), _e17250.member_1, _e17248);
let _e18710 = select((_e17250.member_2 + _e18704), _e17250.member_2, _e17248);
let _e18721 = (((_e18708 * _e18708) + (_e18709 * _e18709)) + (_e18710 * _e18710));
let _e18725 = (1f / sqrt(select(0f, _e18721, (_e18721 > 0f))));
let _e18726 = (_e18708 * _e18725);
let _e18727 = (_e18709 * _e18725);
let _e18728 = (_e18710 * _e18725);
let _e18729 = (_e575 - select(_e17261.member, (_e17261.member + _e18702), _e17248));
let _e18730 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e18703), _e17248));
let _e18731 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e18704), _e17248));
let _e18736 = (((_e18729 * _e18726) + (_e18730 * _e18727)) + (_e18731 * _e18728));
let _e18741 = (((_e18729 * _e613) + (_e18730 * _e626)) + (_e18731 * _e639));
let _e18746 = (((_e18726 * _e613) + (_e18727 * _e626)) + (_e18728 * _e639));
let _e18749 = ((_e18727 * _e639) - (_e18728 * _e626));
let _e18752 = ((_e18728 * _e613) - (_e18726 * _e639));
let _e18755 = ((_e18726 * _e626) - (_e18727 * _e613));
let _e18760 = (((_e18749 * _e18749) + (_e18752 * _e18752)) + (_e18755 * _e18755));
let _e18763 = (1f / select(1e-9f, _e18760, (_e18760 > 1e-9f)));
let _e18766 = ((_e18736 - (_e18746 * _e18741)) * _e18763);
let _e18769 = (((_e18746 * _e18736) - _e18741) * _e18763);
let _e18775 = select(0f, _e18766, (((_e18769 >= 0f) && (_e18769 < _e691)) && (_e18766 > 0f)));
let _e18777 = (_e18641 << bitcast<u32>(_e18267));
if _e18489 {
phi_52709_ = (_e18283.member - 1i);
} else {
phi_52709_ = _e18488;
}
let _e18792 = phi_52709_;
if _e18644 {
phi_52720_ = (_e18283.member_1 - 1i);
} else {
phi_52720_ = _e18643;
}
let _e18795 = phi_52720_;
let _e18799 = (((f32(_e18792) + 0.5f) * _e18288) - 0.5f);
let _e18803 = (((f32(_e18795) + 0.5f) * _e18288) - 0.5f);
if _e453 {
phi_52748_ = type_23(_e18795, _e18792);
} else {
phi_52748_ = type_23(_e18792, _e18795);
}
let _e18809 = phi_52748_;
if _e18359 {
phi_52799_ = 0u;
} else {
if (_e14818 == 1u) {
phi_52798_ = 0u;
} else {
if (_e14818 == 2u) {
phi_52797_ = _e17680;
} else {
phi_52797_ = select(_e17686, _e17683, (_e14818 == 3u));
}
let _e18817 = phi_52797_;
phi_52798_ = _e18817;
}
let _e18819 = phi_52798_;
phi_52799_ = _e18819;
}
let _e18821 = phi_52799_;
local_50 = (((bitcast<i32>(_e18821) + _e18809.member_1) * _e17677) + _e18809.member);
let _e18826 = local_50;
let _e18828 = select(_e17703, _e18826, (_e18826 < _e17703));
let _e18833 = global_6.member[bitcast<u32>(select(0i, _e18828, (_e18828 > 0i)))];
let _e18838 = (((((select(_e18799, _e18803, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e18843 = ((1f - (((select(_e18803, _e18799, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e18850 = ((_e17227.member * _e18838) + (_e17235.member * _e18843));
let _e18851 = ((_e17227.member_1 * _e18838) + (_e17235.member_1 * _e18843));
let _e18852 = ((_e17227.member_2 * _e18838) + (_e17235.member_2 * _e18843));
let _e18856 = select((_e17250.member + _e18850), _e17250.member, _e17248);
let _e18857 = select((_e17250.member_1 + _e18851), _e17250.member_1, _e17248);
let _e18858 = select((_e17250.member_2 + _e18852), _e17250.member_2, _e17248);
let _e18869 = (((_e18856 * _e18856) + (_e18857 * _e18857)) + (_e18858 * _e18858));
let _e18873 = (1f / sqrt(select(0f, _e18869, (_e18869 > 0f))));
let _e18874 = (_e18856 * _e18873);
let _e18875 = (_e18857 * _e18873);
let _e18876 = (_e18858 * _e18873);
let _e18877 = (_e575 - select(_e17261.member, (_e17261.member + _e18850), _e17248));
let _e18878 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e18851), _e17248));
let _e18879 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e18852), _e17248));
let _e18884 = (((_e18877 * _e18874) + (_e18878 * _e18875)) + (_e18879 * _e18876));
let _e18889 = (((_e18877 * _e613) + (_e18878 * _e626)) + (_e18879 * _e639));
let _e18894 = (((_e18874 * _e613) + (_e18875 * _e626)) + (_e18876 * _e639));
let _e18897 = ((_e18875 * _e639) - (_e18876 * _e626));
let _e18900 = ((_e18876 * _e613) - (_e18874 * _e639));
let _e18903 = ((_e18874 * _e626) - (_e18875 * _e613));
let _e18908 = (((_e18897 * _e18897) + (_e18900 * _e18900)) + (_e18903 * _e18903));
let _e18911 = (1f / select(1e-9f, _e18908, (_e18908 > 1e-9f)));
let _e18914 = ((_e18884 - (_e18894 * _e18889)) * _e18911);
let _e18917 = (((_e18894 * _e18884) - _e18889) * _e18911);
let _e18923 = select(0f, _e18914, (((_e18917 >= 0f) && (_e18917 < _e691)) && (_e18914 > 0f)));
let _e18925 = (_e18792 << bitcast<u32>(_e18267));
let _e18937 = select(((((_e18266 - select(0f, (_e18328 * _e18329), (((select(select(_e766, _e927, (_e18473 >= _e692)), _e847, (_e18473 < _e298)) == _e14818) && (_e18471 > 0f)) && (_e18471 < _e18381)))) - select(0f, (_e18325 * _e18329), (((select(select(_e766, _e927, (_e18625 >= _e692)), _e847, (_e18625 < _e298)) == _e14818) && (_e18623 > 0f)) && (_e18623 < _e18533)))) - select(0f, (_e18328 * _e18327), (((select(select(_e766, _e927, (_e18777 >= _e692)), _e847, (_e18777 < _e298)) == _e14818) && (_e18775 > 0f)) && (_e18775 < _e18685)))) - select(0f, (_e18325 * _e18327), (((select(select(_e766, _e927, (_e18925 >= _e692)), _e847, (_e18925 < _e298)) == _e14818) && (_e18923 > 0f)) && (_e18923 < _e18833)))), _e18266, _e18359);
let _e18938 = (_e14822 & 31u);
let _e18940 = (1u << bitcast<u32>(_e18938));
let _e18949 = bitcast<i32>((((_e14761 + _e18940) - 1u) >> bitcast<u32>(_e18938)));
let _e18950 = bitcast<i32>((((_e14764 + _e18940) - 1u) >> bitcast<u32>(_e18938)));
if _e453 {
phi_53478_ = type_23(_e18950, _e18949);
} else {
phi_53478_ = type_23(_e18949, _e18950);
}
let _e18954 = phi_53478_;
let _e18959 = f32((1i << bitcast<u32>(_e18938)));
let _e18960 = (1f / _e18959);
let _e18962 = ((_e17035 * _e18960) - 0.5f);
let _e18964 = ((_e17128 * _e18960) - 0.5f);
let _e18966 = select(-1f, _e18962, (_e18962 > -1f));
let _e18968 = select(1e6f, _e18966, (_e18966 < 1e6f));
let _e18975 = select(0i, select(select(i32(_e18968), i32(-2147483648), (_e18968 < -2147483600f)), 2147483647i, (_e18968 > 2147483500f)), (_e18968 == _e18968));
let _e18979 = (_e18975 - select(0i, 1i, (_e18968 < f32(_e18975))));
let _e18981 = select(-1f, _e18964, (_e18964 > -1f));
let _e18983 = select(1e6f, _e18981, (_e18981 < 1e6f));
let _e18990 = select(0i, select(select(i32(_e18983), i32(-2147483648), (_e18983 < -2147483600f)), 2147483647i, (_e18983 > 2147483500f)), (_e18983 == _e18983));
let _e18994 = (_e18990 - select(0i, 1i, (_e18983 < f32(_e18990))));
let _e18996 = (_e18962 - f32(_e18979));
let _e18998 = (_e18964 - f32(_e18994));
let _e18999 = (1f - _e18996);
let _e19000 = (1f - _e18998);
let _e19003 = select(_e18979, 0i, (_e18979 < 0i));
let _e19004 = (_e19003 >= _e18954.member);
if _e19004 {
phi_53556_ = (_e18954.member - 1i);
} else {
phi_53556_ = _e19003;
}
let _e19007 = phi_53556_;
let _e19009 = select(_e18994, 0i, (_e18994 < 0i));
let _e19010 = (_e19009 >= _e18954.member_1);
if _e19010 {
phi_53567_ = (_e18954.member_1 - 1i);
} else {
phi_53567_ = _e19009;
}
let _e19013 = phi_53567_;
let _e19017 = (((f32(_e19007) + 0.5f) * _e18959) - 0.5f);
let _e19021 = (((f32(_e19013) + 0.5f) * _e18959) - 0.5f);
if _e453 {
phi_53595_ = type_23(_e19013, _e19007);
} else {
phi_53595_ = type_23(_e19007, _e19013);
}
let _e19027 = phi_53595_;
let _e19030 = (_e14822 == 0u);
if _e19030 {
phi_53646_ = 0u;
} else {
if (_e14822 == 1u) {
phi_53645_ = 0u;
} else {
if (_e14822 == 2u) {
phi_53644_ = _e17680;
} else {
phi_53644_ = select(_e17686, _e17683, (_e14822 == 3u));
}
let _e19036 = phi_53644_;
phi_53645_ = _e19036;
}
let _e19038 = phi_53645_;
phi_53646_ = _e19038;
}
let _e19040 = phi_53646_;
local_48 = (((bitcast<i32>(_e19040) + _e19027.member_1) * _e17677) + _e19027.member);
let _e19045 = local_48;
let _e19047 = select(_e17703, _e19045, (_e19045 < _e17703));
let _e19052 = global_6.member[bitcast<u32>(select(0i, _e19047, (_e19047 > 0i)))];
let _e19057 = (((((select(_e19017, _e19021, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e19062 = ((1f - (((select(_e19021, _e19017, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e19069 = ((_e17227.member * _e19057) + (_e17235.member * _e19062));
let _e19070 = ((_e17227.member_1 * _e19057) + (_e17235.member_1 * _e19062));
let _e19071 = ((_e17227.member_2 * _e19057) + (_e17235.member_2 * _e19062));
let _e19075 = select((_e17250.member + _e19069), _e17250.member, _e17248);
let _e19076 = select((_e17250.member_1 + _e19070), _e17250.member_1, _e17248);
let _e19077 = select((_e17250.member_2 + _e19071), _e17250.member_2, _e17248);
let _e19088 = (((_e19075 * _e19075) + (_e19076 * _e19076)) + (_e19077 * _e19077));
let _e19092 = (1f / sqrt(select(0f, _e19088, (_e19088 > 0f))));
let _e19093 = (_e19075 * _e19092);
let _e19094 = (_e19076 * _e19092);
let _e19095 = (_e19077 * _e19092);
let _e19096 = (_e575 - select(_e17261.member, (_e17261.member + _e19069), _e17248));
let _e19097 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e19070), _e17248));
let _e19098 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e19071), _e17248));
let _e19103 = (((_e19096 * _e19093) + (_e19097 * _e19094)) + (_e19098 * _e19095));
let _e19108 = (((_e19096 * _e613) + (_e19097 * _e626)) + (_e19098 * _e639));
let _e19113 = (((_e19093 * _e613) + (_e19094 * _e626)) + (_e19095 * _e639));
let _e19116 = ((_e19094 * _e639) - (_e19095 * _e626));
let _e19119 = ((_e19095 * _e613) - (_e19093 * _e639));
let _e19122 = ((_e19093 * _e626) - (_e19094 * _e613));
let _e19127 = (((_e19116 * _e19116) + (_e19119 * _e19119)) + (_e19122 * _e19122));
let _e19130 = (1f / select(1e-9f, _e19127, (_e19127 > 1e-9f)));
let _e19133 = ((_e19103 - (_e19113 * _e19108)) * _e19130);
let _e19136 = (((_e19113 * _e19103) - _e19108) * _e19130);
let _e19142 = select(0f, _e19133, (((_e19136 >= 0f) && (_e19136 < _e691)) && (_e19133 > 0f)));
let _e19144 = (_e19007 << bitcast<u32>(_e18938));
let _e19156 = (_e18979 + 1i);
let _e19159 = select(_e19156, 0i, (_e19156 < 0i));
let _e19160 = (_e19159 >= _e18954.member);
if _e19160 {
phi_54307_ = (_e18954.member - 1i);
} else {
phi_54307_ = _e19159;
}
let _e19163 = phi_54307_;
if _e19010 {
phi_54318_ = (_e18954.member_1 - 1i);
} else {
phi_54318_ = _e19009;
}
let _e19166 = phi_54318_;
let _e19170 = (((f32(_e19163) + 0.5f) * _e18959) - 0.5f);
let _e19174 = (((f32(_e19166) + 0.5f) * _e18959) - 0.5f);
if _e453 {
phi_54346_ = type_23(_e19166, _e19163);
} else {
phi_54346_ = type_23(_e19163, _e19166);
}
let _e19180 = phi_54346_;
if _e19030 {
phi_54397_ = 0u;
} else {
if (_e14822 == 1u) {
phi_54396_ = 0u;
} else {
if (_e14822 == 2u) {
phi_54395_ = _e17680;
} else {
phi_54395_ = select(_e17686, _e17683, (_e14822 == 3u));
}
let _e19188 = phi_54395_;
phi_54396_ = _e19188;
}
let _e19190 = phi_54396_;
phi_54397_ = _e19190;
}
let _e19192 = phi_54397_;
local_46 = (((bitcast<i32>(_e19192) + _e19180.member_1) * _e17677) + _e19180.member);
let _e19197 = local_46;
let _e19199 = select(_e17703, _e19197, (_e19197 < _e17703));
let _e19204 = global_6.member[bitcast<u32>(select(0i, _e19199, (_e19199 > 0i)))];
let _e19209 = (((((select(_e19170, _e19174, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e19214 = ((1f - (((select(_e19174, _e19170, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e19221 = ((_e17227.member * _e19209) + (_e17235.member * _e19214));
let _e19222 = ((_e17227.member_1 * _e19209) + (_e17235.member_1 * _e19214));
let _e19223 = ((_e17227.member_2 * _e19209) + (_e17235.member_2 * _e19214));
let _e19227 = select((_e17250.member + _e19221), _e17250.member, _e17248);
let _e19228 = select((_e17250.member_1 + _e19222), _e17250.member_1, _e17248);
let _e19229 = select((_e17250.member_2 + _e19223), _e17250.member_2, _e17248);
let _e19240 = (((_e19227 * _e19227) + (_e19228 * _e19228)) + (_e19229 * _e19229));
let _e19244 = (1f / sqrt(select(0f, _e19240, (_e19240 > 0f))));
let _e19245 = (_e19227 * _e19244);
let _e19246 = (_e19228 * _e19244);
let _e19247 = (_e19229 * _e19244);
let _e19248 = (_e575 - select(_e17261.member, (_e17261.member + _e19221), _e17248));
let _e19249 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e19222), _e17248));
let _e19250 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e19223), _e17248));
let _e19255 = (((_e19248 * _e19245) + (_e19249 * _e19246)) + (_e19250 * _e19247));
let _e19260 = (((_e19248 * _e613) + (_e19249 * _e626)) + (_e19250 * _e639));
let _e19265 = (((_e19245 * _e613) + (_e19246 * _e626)) + (_e19247 * _e639));
let _e19268 = ((_e19246 * _e639) - (_e19247 * _e626));
let _e19271 = ((_e19247 * _e613) - (_e19245 * _e639));
let _e19274 = ((_e19245 * _e626) - (_e19246 * _e613));
let _e19279 = (((_e19268 * _e19268) + (_e19271 * _e19271)) + (_e19274 * _e19274));
let _e19282 = (1f / select(1e-9f, _e19279, (_e19279 > 1e-9f)));
let _e19285 = ((_e19255 - (_e19265 * _e19260)) * _e19282);
let _e19288 = (((_e19265 * _e19255) - _e19260) * _e19282);
let _e19294 = select(0f, _e19285, (((_e19288 >= 0f) && (_e19288 < _e691)) && (_e19285 > 0f)));
let _e19296 = (_e19163 << bitcast<u32>(_e18938));
let _e19308 = (_e18994 + 1i);
if _e19004 {
phi_55058_ = (_e18954.member - 1i);
} else {
phi_55058_ = _e19003;
}
let _e19312 = phi_55058_;
let _e19314 = select(_e19308, 0i, (_e19308 < 0i));
let _e19315 = (_e19314 >= _e18954.member_1);
if _e19315 {
phi_55069_ = (_e18954.member_1 - 1i);
} else {
phi_55069_ = _e19314;
}
let _e19318 = phi_55069_;
let _e19322 = (((f32(_e19312) + 0.5f) * _e18959) - 0.5f);
let _e19326 = (((f32(_e19318) + 0.5f) * _e18959) - 0.5f);
if _e453 {
phi_55097_ = type_23(_e19318, _e19312);
} else {
phi_55097_ = type_23(_e19312, _e19318);
}
let _e19332 = phi_55097_;
if _e19030 {
phi_55148_ = 0u;
} else {
if (_e14822 == 1u) {
phi_55147_ = 0u;
} else {
if (_e14822 == 2u) {
phi_55146_ = _e17680;
} else {
phi_55146_ = select(_e17686, _e17683, (_e14822 == 3u));
}
let _e19340 = phi_55146_;
phi_55147_ = _e19340;
}
let _e19342 = phi_55147_;
phi_55148_ = _e19342;
}
let _e19344 = phi_55148_;
local_44 = (((bitcast<i32>(_e19344) + _e19332.member_1) * _e17677) + _e19332.member);
let _e19349 = local_44;
let _e19351 = select(_e17703, _e19349, (_e19349 < _e17703));
let _e19356 = global_6.member[bitcast<u32>(select(0i, _e19351, (_e19351 > 0i)))];
let _e19361 = (((((select(_e19322, _e19326, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e19366 = ((1f - (((select(_e19326, _e19322, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e19373 = ((_e17227.member * _e19361) + (_e17235.member * _e19366));
let _e19374 = ((_e17227.member_1 * _e19361) + (_e17235.member_1 * _e19366));
let _e19375 = ((_e17227.member_2 * _e19361) + (_e17235.member_2 * _e19366));
let _e19379 = select((_e17250.member + _e19373), _e17250.member, _e17248);
let _e19380 = select((_e17250.member_1 + _e19374), _e17250.member_1, _e17248);
let _e19381 = select((_e17250.member_2 + _e19375), _e17250.member_2, _e17248);
let _e19392 = (((_e19379 * _e19379) + (_e19380 * _e19380)) + (_e19381 * _e19381));
let _e19396 = (1f / sqrt(select(0f, _e19392, (_e19392 > 0f))));
let _e19397 = (_e19379 * _e19396);
let _e19398 = (_e19380 * _e19396);
let _e19399 = (_e19381 * _e19396);
let _e19400 = (_e575 - select(_e17261.member, (_e17261.member + _e19373), _e17248));
let _e19401 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e19374), _e17248));
let _e19402 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e19375), _e17248));
let _e19407 = (((_e19400 * _e19397) + (_e19401 * _e19398)) + (_e19402 * _e19399));
let _e19412 = (((_e19400 * _e613) + (_e19401 * _e626)) + (_e19402 * _e639));
let _e19417 = (((_e19397 * _e613) + (_e19398 * _e626)) + (_e19399 * _e639));
let _e19420 = ((_e19398 * _e639) - (_e19399 * _e626));
let _e19423 = ((_e19399 * _e613) - (_e19397 * _e639));
let _e19426 = ((_e19397 * _e626) - (_e19398 * _e613));
let _e19431 = (((_e19420 * _e19420) + (_e19423 * _e19423)) + (_e19426 * _e19426));
let _e19434 = (1f / select(1e-9f, _e19431, (_e19431 > 1e-9f)));
let _e19437 = ((_e19407 - (_e19417 * _e19412)) * _e19434);
let _e19440 = (((_e19417 * _e19407) - _e19412) * _e19434);
let _e19446 = select(0f, _e19437, (((_e19440 >= 0f) && (_e19440 < _e691)) && (_e19437 > 0f)));
let _e19448 = (_e19312 << bitcast<u32>(_e18938));
if _e19160 {
phi_55809_ = (_e18954.member - 1i);
} else {
phi_55809_ = _e19159;
}
let _e19463 = phi_55809_;
if _e19315 {
phi_55820_ = (_e18954.member_1 - 1i);
} else {
phi_55820_ = _e19314;
}
let _e19466 = phi_55820_;
let _e19470 = (((f32(_e19463) + 0.5f) * _e18959) - 0.5f);
let _e19474 = (((f32(_e19466) + 0.5f) * _e18959) - 0.5f);
if _e453 {
phi_55848_ = type_23(_e19466, _e19463);
} else {
phi_55848_ = type_23(_e19463, _e19466);
}
let _e19480 = phi_55848_;
if _e19030 {
phi_55899_ = 0u;
} else {
if (_e14822 == 1u) {
phi_55898_ = 0u;
} else {
if (_e14822 == 2u) {
phi_55897_ = _e17680;
} else {
phi_55897_ = select(_e17686, _e17683, (_e14822 == 3u));
}
let _e19488 = phi_55897_;
phi_55898_ = _e19488;
}
let _e19490 = phi_55898_;
phi_55899_ = _e19490;
}
let _e19492 = phi_55899_;
local_42 = (((bitcast<i32>(_e19492) + _e19480.member_1) * _e17677) + _e19480.member);
let _e19497 = local_42;
let _e19499 = select(_e17703, _e19497, (_e19497 < _e17703));
let _e19504 = global_6.member[bitcast<u32>(select(0i, _e19499, (_e19499 > 0i)))];
let _e19509 = (((((select(_e19470, _e19474, _e453) + 0.5f) / _e17208) * 2f) - 1f) * _e17216);
let _e19514 = ((1f - (((select(_e19474, _e19470, _e453) + 0.5f) / _e17209) * 2f)) * _e17224);
let _e19521 = ((_e17227.member * _e19509) + (_e17235.member * _e19514));
let _e19522 = ((_e17227.member_1 * _e19509) + (_e17235.member_1 * _e19514));
let _e19523 = ((_e17227.member_2 * _e19509) + (_e17235.member_2 * _e19514));
let _e19527 = select((_e17250.member + _e19521), _e17250.member, _e17248);
let _e19528 = select((_e17250.member_1 + _e19522), _e17250.member_1, _e17248);
let _e19529 = select((_e17250.member_2 + _e19523), _e17250.member_2, _e17248);
let _e19540 = (((_e19527 * _e19527) + (_e19528 * _e19528)) + (_e19529 * _e19529));
let _e19544 = (1f / sqrt(select(0f, _e19540, (_e19540 > 0f))));
let _e19545 = (_e19527 * _e19544);
let _e19546 = (_e19528 * _e19544);
let _e19547 = (_e19529 * _e19544);
let _e19548 = (_e575 - select(_e17261.member, (_e17261.member + _e19521), _e17248));
let _e19549 = (_e587 - select(_e17261.member_1, (_e17261.member_1 + _e19522), _e17248));
let _e19550 = (_e600 - select(_e17261.member_2, (_e17261.member_2 + _e19523), _e17248));
let _e19555 = (((_e19548 * _e19545) + (_e19549 * _e19546)) + (_e19550 * _e19547));
let _e19560 = (((_e19548 * _e613) + (_e19549 * _e626)) + (_e19550 * _e639));
let _e19565 = (((_e19545 * _e613) + (_e19546 * _e626)) + (_e19547 * _e639));
let _e19568 = ((_e19546 * _e639) - (_e19547 * _e626));
let _e19571 = ((_e19547 * _e613) - (_e19545 * _e639));
let _e19574 = ((_e19545 * _e626) - (_e19546 * _e613));
let _e19579 = (((_e19568 * _e19568) + (_e19571 * _e19571)) + (_e19574 * _e19574));
let _e19582 = (1f / select(1e-9f, _e19579, (_e19579 > 1e-9f)));
let _e19585 = ((_e19555 - (_e19565 * _e19560)) * _e19582);
let _e19588 = (((_e19565 * _e19555) - _e19560) * _e19582);
let _e19594 = select(0f, _e19585, (((_e19588 >= 0f) && (_e19588 < _e691)) && (_e19585 > 0f)));
let _e19596 = (_e19463 << bitcast<u32>(_e18938));
let _e19608 = select(((((_e18937 - select(0f, (_e18999 * _e19000), (((select(select(_e766, _e927, (_e19144 >= _e692)), _e847, (_e19144 < _e298)) == _e14822) && (_e19142 > 0f)) && (_e19142 < _e19052)))) - select(0f, (_e18996 * _e19000), (((select(select(_e766, _e927, (_e19296 >= _e692)), _e847, (_e19296 < _e298)) == _e14822) && (_e19294 > 0f)) && (_e19294 < _e19204)))) - select(0f, (_e18999 * _e18998), (((select(select(_e766, _e927, (_e19448 >= _e692)), _e847, (_e19448 < _e298)) == _e14822) && (_e19446 > 0f)) && (_e19446 < _e19356)))) - select(0f, (_e18996 * _e18998), (((select(select(_e766, _e927, (_e19596 >= _e692)), _e847, (_e19596 < _e298)) == _e14822) && (_e19594 > 0f)) && (_e19594 < _e19504)))), _e18937, _e19030);
if _e453 {
phi_56569_ = type_23(_e17125, _e17033);
} else {
phi_56569_ = type_23(_e17033, _e17125);
}
let _e19623 = phi_56569_;
let _e19626 = (_e17126 && (((_e17581 > 0f) && (_e17581 < _e17205)) && (bitcast<f32>((bitcast<u32>(_e19608) & 2147483647u)) > 1e-6f)));
let _e19629 = global_1.member.member_18.member;
let _e19630 = (((select(_e17151, (1f - _e17151), (_e17136 >= 0f)) - select(_e17170, (1f - _e17170), (_e17155 >= 0f))) * (1f / _e17133)) * _e19629);
let _e19634 = select(0f, (((((_e652 * _e17418.member) * ((1f + (_e17458 * (1f + (_e17458 * (0.5f + (_e17458 * (0.16666667f + (_e17458 * (0.041666668f + (_e17458 * (0.008333334f + (_e17458 * (0.001388889f + (_e17458 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17453 + 127i)) << bitcast<u32>(23i))))) * _e17411) * _e19608) * _e19630), _e19626);
let _e19635 = select(0f, (((((_e665 * _e17418.member_1) * ((1f + (_e17506 * (1f + (_e17506 * (0.5f + (_e17506 * (0.16666667f + (_e17506 * (0.041666668f + (_e17506 * (0.008333334f + (_e17506 * (0.001388889f + (_e17506 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17501 + 127i)) << bitcast<u32>(23i))))) * _e17411) * _e19608) * _e19630), _e19626);
let _e19636 = select(0f, (((((_e678 * _e17418.member_2) * ((1f + (_e17554 * (1f + (_e17554 * (0.5f + (_e17554 * (0.16666667f + (_e17554 * (0.041666668f + (_e17554 * (0.008333334f + (_e17554 * (0.001388889f + (_e17554 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17549 + 127i)) << bitcast<u32>(23i))))) * _e17411) * _e19608) * _e19630), _e19626);
let _e19640 = (bitcast<f32>((bitcast<u32>(_e19634) & 2147483647u)) >= 1073741800f);
let _e19641 = (1f / 1048576f);
let _e19644 = ((_e19634 * select(1f, _e19641, _e19640)) + 0.5f);
let _e19646 = select(-1073741800f, _e19644, (_e19644 > -1073741800f));
let _e19648 = select(1073741800f, _e19646, (_e19646 < 1073741800f));
let _e19655 = select(0i, select(select(i32(_e19648), i32(-2147483648), (_e19648 < -2147483600f)), 2147483647i, (_e19648 > 2147483500f)), (_e19648 == _e19648));
let _e19659 = (_e19655 - select(0i, 1i, (_e19648 < f32(_e19655))));
let _e19660 = select(0i, 20i, _e19640);
let _e19664 = (bitcast<u32>(_e19659) << bitcast<u32>((_e19660 & 31i)));
let _e19671 = bitcast<u32>(((_e19659 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19660) & 31i))));
let _e19675 = (bitcast<f32>((bitcast<u32>(_e19635) & 2147483647u)) >= 1073741800f);
let _e19678 = ((_e19635 * select(1f, _e19641, _e19675)) + 0.5f);
let _e19680 = select(-1073741800f, _e19678, (_e19678 > -1073741800f));
let _e19682 = select(1073741800f, _e19680, (_e19680 < 1073741800f));
let _e19689 = select(0i, select(select(i32(_e19682), i32(-2147483648), (_e19682 < -2147483600f)), 2147483647i, (_e19682 > 2147483500f)), (_e19682 == _e19682));
let _e19693 = (_e19689 - select(0i, 1i, (_e19682 < f32(_e19689))));
let _e19694 = select(0i, 20i, _e19675);
let _e19698 = (bitcast<u32>(_e19693) << bitcast<u32>((_e19694 & 31i)));
let _e19705 = bitcast<u32>(((_e19693 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19694) & 31i))));
let _e19709 = (bitcast<f32>((bitcast<u32>(_e19636) & 2147483647u)) >= 1073741800f);
let _e19712 = ((_e19636 * select(1f, _e19641, _e19709)) + 0.5f);
let _e19714 = select(-1073741800f, _e19712, (_e19712 > -1073741800f));
let _e19716 = select(1073741800f, _e19714, (_e19714 < 1073741800f));
let _e19723 = select(0i, select(select(i32(_e19716), i32(-2147483648), (_e19716 < -2147483600f)), 2147483647i, (_e19716 > 2147483500f)), (_e19716 == _e19716));
let _e19727 = (_e19723 - select(0i, 1i, (_e19716 < f32(_e19723))));
let _e19728 = select(0i, 20i, _e19709);
let _e19732 = (bitcast<u32>(_e19727) << bitcast<u32>((_e19728 & 31i)));
let _e19739 = bitcast<u32>(((_e19727 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19728) & 31i))));
let _e19744 = bitcast<i32>(bitcast<u32>((((_e19623.member_1 * _e14765) + _e19623.member) * 6i)));
if ((_e19664 | _e19671) == 0u) {
} else {
let _e19747 = bitcast<u32>(_e19744);
if (_e19747 < _e270) {
let _e19751 = atomicAdd((&global_8.member[_e19747]), _e19664);
phi_56802_ = _e19751;
} else {
phi_56802_ = 0u;
}
let _e19753 = phi_56802_;
let _e19757 = (_e19671 + select(0u, 1u, ((_e19753 + _e19664) < _e19664)));
if (_e19757 == 0u) {
} else {
let _e19759 = (_e19747 + 1u);
if (_e19759 < _e270) {
let _e19763 = atomicAdd((&global_8.member[_e19759]), _e19757);
}
}
}
if ((_e19698 | _e19705) == 0u) {
} else {
let _e19767 = bitcast<u32>((_e19744 + 2i));
if (_e19767 < _e270) {
let _e19771 = atomicAdd((&global_8.member[_e19767]), _e19698);
phi_56832_ = _e19771;
} else {
phi_56832_ = 0u;
}
let _e19773 = phi_56832_;
let _e19777 = (_e19705 + select(0u, 1u, ((_e19773 + _e19698) < _e19698)));
if (_e19777 == 0u) {
} else {
let _e19779 = (_e19767 + 1u);
if (_e19779 < _e270) {
let _e19783 = atomicAdd((&global_8.member[_e19779]), _e19777);
}
}
}
if ((_e19732 | _e19739) == 0u) {
} else {
let _e19787 = bitcast<u32>((_e19744 + 4i));
if (_e19787 < _e270) {
let _e19791 = atomicAdd((&global_8.member[_e19787]), _e19732);
phi_56862_ = _e19791;
} else {
phi_56862_ = 0u;
}
let _e19793 = phi_56862_;
let _e19797 = (_e19739 + select(0u, 1u, ((_e19793 + _e19732) < _e19732)));
if (_e19797 == 0u) {
} else {
let _e19799 = (_e19787 + 1u);
if (_e19799 < _e270) {
let _e19803 = atomicAdd((&global_8.member[_e19799]), _e19797);
}
}
}
phi_46478_ = (_e17123 + 1i);
} else {
phi_46478_ = i32();
}
let _e19806 = phi_46478_;
continue;
continuing {
phi_46477_ = _e19806;
break if !(_e17126);
}
}
phi_46324_ = (_e17030 + 1i);
} else {
phi_46324_ = i32();
}
let _e19810 = phi_46324_;
continue;
continuing {
phi_46323_ = _e19810;
break if !(_e17031);
}
}
}
}
} else {
let _e19812 = (_e766 & 31u);
let _e19814 = (1u << bitcast<u32>(_e19812));
let _e19823 = bitcast<i32>((((_e14761 + _e19814) - 1u) >> bitcast<u32>(_e19812)));
let _e19824 = bitcast<i32>((((_e14764 + _e19814) - 1u) >> bitcast<u32>(_e19812)));
if _e453 {
phi_56928_ = type_23(_e19824, _e19823);
} else {
phi_56928_ = type_23(_e19823, _e19824);
}
let _e19828 = phi_56928_;
let _e19832 = (_e14791 >> bitcast<u32>(_e19812));
if (_e19832 < _e19828.member) {
phi_57003_ = _e19832;
} else {
phi_57003_ = (_e19828.member - 1i);
}
let _e19838 = phi_57003_;
phi_57007_ = type_23(2147483647i, -1i);
phi_57010_ = 0i;
loop {
let _e19841 = phi_57007_;
let _e19843 = phi_57010_;
local_233 = _e19841;
local_234 = _e19841;
let _e19844 = (_e19843 < 16i);
if _e19844 {
let _e19846 = (1i << bitcast<u32>(_e19812));
let _e19847 = f32(_e19846);
let _e19849 = ((4u - _e766) & 31u);
let _e19854 = ((_e14809 >> bitcast<u32>(_e19812)) + (_e19843 & ((1i << bitcast<u32>(_e19849)) - 1i)));
let _e19858 = (((f32(_e19854) + 0.5f) * _e19847) - 0.5f);
let _e19862 = (-(((_e416 * _e19858) + _e442)) / _e429);
let _e19869 = bitcast<f32>((bitcast<u32>(((_e466 * _e19858) + ((_e479 * _e19862) + _e492))) & 2147483647u));
let _e19876 = bitcast<f32>((bitcast<u32>(((_e505 * _e19858) + ((_e518 * _e19862) + _e531))) & 2147483647u));
let _e19881 = (((0.5f * (_e19869 + _e19876)) / _e534) + (0.5f * _e19847));
let _e19882 = (1f / _e19847);
let _e19890 = ((((_e19862 + _e19881) + 0.5f) * _e19882) - 0.5f);
let _e19891 = f32((_e19828.member_1 - 1i));
let _e19892 = (0f - 1f);
let _e19894 = select(_e19892, _e19890, (_e19890 > _e19892));
let _e19896 = select(_e19891, _e19894, (_e19894 < _e19891));
let _e19903 = select(0i, select(select(i32(_e19896), i32(-2147483648), (_e19896 < -2147483600f)), 2147483647i, (_e19896 > 2147483500f)), (_e19896 == _e19896));
let _e19908 = (((((_e19862 - _e19881) + 0.5f) * _e19882) - 0.5f) + 1f);
let _e19909 = (_e19891 + 1f);
let _e19911 = select(0f, _e19908, (_e19908 > 0f));
let _e19913 = select(_e19909, _e19911, (_e19911 < _e19909));
let _e19920 = select(0i, select(select(i32(_e19913), i32(-2147483648), (_e19913 < -2147483600f)), 2147483647i, (_e19913 > 2147483500f)), (_e19913 == _e19913));
let _e19931 = ((1e-4f * _e19847) * _e534);
let _e19933 = select(_e19876, _e19869, (_e19869 > _e19876));
let _e19935 = select(_e19931, _e19933, (_e19933 > _e19931));
let _e19937 = select(_e19876, _e19869, (_e19869 < _e19876));
let _e19939 = select(_e19931, _e19937, (_e19937 > _e19931));
let _e19941 = (0.5f * (_e19935 + _e19939));
let _e19942 = (0.5f / _e19939);
let _e19943 = (1f / _e19935);
phi_57161_ = _e19841;
phi_57164_ = 0i;
loop {
let _e19945 = phi_57161_;
let _e19947 = phi_57164_;
local_242 = _e19945;
let _e19950 = (((_e19920 - select(0i, 1i, (_e19913 < f32(_e19920)))) + (_e19843 >> bitcast<u32>(_e19849))) + (_e19947 << bitcast<u32>(_e19812)));
let _e19951 = (_e19950 <= select(-1i, (_e19903 - select(0i, 1i, (_e19896 < f32(_e19903)))), (_e19854 <= _e19838)));
if _e19951 {
let _e19955 = (((f32(_e19950) + 0.5f) * _e19847) - 0.5f);
let _e19957 = ((_e19955 - _e19862) * _e534);
let _e19958 = (_e534 * _e19847);
let _e19960 = (0.5f * _e19958);
let _e19961 = (_e19957 + _e19960);
let _e19962 = -(_e19961);
let _e19965 = (_e19941 - select(_e19962, _e19961, (_e19961 > _e19962)));
let _e19967 = select(0f, _e19965, (_e19965 > 0f));
let _e19969 = select(_e19939, _e19967, (_e19967 < _e19939));
let _e19972 = (_e19965 - _e19939);
let _e19976 = (((_e19969 * (_e19969 * _e19942)) + select(0f, _e19972, (_e19972 > 0f))) * _e19943);
let _e19980 = (_e19957 - _e19960);
let _e19981 = -(_e19980);
let _e19984 = (_e19941 - select(_e19981, _e19980, (_e19980 > _e19981)));
let _e19986 = select(0f, _e19984, (_e19984 > 0f));
let _e19988 = select(_e19939, _e19986, (_e19986 < _e19939));
let _e19991 = (_e19984 - _e19939);
let _e19995 = (((_e19988 * (_e19988 * _e19942)) + select(0f, _e19991, (_e19991 > 0f))) * _e19943);
if _e453 {
phi_57294_ = type_23(_e19950, _e19854);
} else {
phi_57294_ = type_23(_e19854, _e19950);
}
let _e20006 = phi_57294_;
let _e20012 = bitcast<i32>(((_e14761 + 1u) >> bitcast<u32>(1u)));
let _e20015 = global_1.member.member_18.member_9;
let _e20020 = global_1.member.member_18.member_6;
let _e20023 = global_1.member.member_18.member_7;
let _e20026 = global_1.member.member_18.member_8;
if _e14816 {
phi_57345_ = 0u;
} else {
if (_e766 == 1u) {
phi_57344_ = 0u;
} else {
if (_e766 == 2u) {
phi_57343_ = _e20020;
} else {
phi_57343_ = select(_e20026, _e20023, (_e766 == 3u));
}
let _e20032 = phi_57343_;
phi_57344_ = _e20032;
}
let _e20034 = phi_57344_;
phi_57345_ = _e20034;
}
let _e20036 = phi_57345_;
local_40 = (((bitcast<i32>(_e20036) + _e20006.member_1) * _e20012) + _e20006.member);
local_41 = (_e20012 * bitcast<i32>(_e20015));
let _e20041 = local_40;
let _e20043 = (bitcast<i32>(_e262) - 1i);
let _e20045 = select(_e20043, _e20041, (_e20041 < _e20043));
let _e20050 = global_6.member[bitcast<u32>(select(0i, _e20045, (_e20045 > 0i)))];
let _e20051 = local_41;
let _e20052 = local_40;
let _e20053 = (_e20051 + _e20052);
let _e20055 = select(_e20043, _e20053, (_e20053 < _e20043));
let _e20060 = global_6.member[bitcast<u32>(select(0i, _e20055, (_e20055 > 0i)))];
let _e20061 = local_41;
let _e20063 = local_40;
let _e20064 = ((2i * _e20061) + _e20063);
let _e20066 = select(_e20043, _e20064, (_e20064 < _e20043));
let _e20071 = global_6.member[bitcast<u32>(select(0i, _e20066, (_e20066 > 0i)))];
let _e20073 = (_e19846 >> bitcast<u32>(1i));
let _e20076 = ((_e20006.member << bitcast<u32>(_e19812)) + _e20073);
let _e20079 = ((_e20006.member_1 << bitcast<u32>(_e19812)) + _e20073);
let _e20081 = select(_e20076, 0i, (_e20076 < 0i));
if (_e20081 >= _e14765) {
phi_57471_ = (_e14765 - 1i);
} else {
phi_57471_ = _e20081;
}
let _e20085 = phi_57471_;
let _e20087 = select(_e20079, 0i, (_e20079 < 0i));
if (_e20087 >= _e14766) {
phi_57482_ = (_e14766 - 1i);
} else {
phi_57482_ = _e20087;
}
let _e20091 = phi_57482_;
local_38 = bitcast<i32>((_e14761 * _e14764));
local_39 = ((_e20091 * _e14765) + _e20085);
let _e20096 = local_38;
let _e20097 = local_39;
let _e20098 = (_e20096 + _e20097);
let _e20100 = (bitcast<i32>(_e259) - 1i);
let _e20102 = select(_e20100, _e20098, (_e20098 < _e20100));
let _e20107 = global_5.member[bitcast<u32>(select(0i, _e20102, (_e20102 > 0i)))];
let _e20116 = global_1.member.member_2.member;
let _e20117 = (((((select(_e19858, _e19955, _e453) + 0.5f) / f32(_e14765)) * 2f) - 1f) * _e20116);
let _e20124 = global_1.member.member_2.member_1;
let _e20125 = ((1f - (((select(_e19955, _e19858, _e453) + 0.5f) / f32(_e14766)) * 2f)) * _e20124);
let _e20127 = global_1.member.member_3;
let _e20135 = global_1.member.member_4;
let _e20142 = ((_e20127.member * _e20117) + (_e20135.member * _e20125));
let _e20143 = ((_e20127.member_1 * _e20117) + (_e20135.member_1 * _e20125));
let _e20144 = ((_e20127.member_2 * _e20117) + (_e20135.member_2 * _e20125));
let _e20147 = global_1.member.member_2.member_3;
let _e20148 = (_e20147 != 0u);
let _e20150 = global_1.member.member_5;
let _e20157 = select((_e20150.member + _e20142), _e20150.member, _e20148);
let _e20158 = select((_e20150.member_1 + _e20143), _e20150.member_1, _e20148);
let _e20159 = select((_e20150.member_2 + _e20144), _e20150.member_2, _e20148);
let _e20161 = global_1.member.member_6;
let _e20175 = (((_e20157 * _e20157) + (_e20158 * _e20158)) + (_e20159 * _e20159));
let _e20178 = sqrt(select(0f, _e20175, (_e20175 > 0f)));
let _e20179 = (1f / _e20178);
let _e20180 = (_e20157 * _e20179);
let _e20181 = (_e20158 * _e20179);
let _e20182 = (_e20159 * _e20179);
let _e20183 = (_e575 - select(_e20161.member, (_e20161.member + _e20142), _e20148));
let _e20184 = (_e587 - select(_e20161.member_1, (_e20161.member_1 + _e20143), _e20148));
let _e20185 = (_e600 - select(_e20161.member_2, (_e20161.member_2 + _e20144), _e20148));
let _e20190 = (((_e20183 * _e20180) + (_e20184 * _e20181)) + (_e20185 * _e20182));
let _e20195 = (((_e20183 * _e613) + (_e20184 * _e626)) + (_e20185 * _e639));
let _e20200 = (((_e20180 * _e613) + (_e20181 * _e626)) + (_e20182 * _e639));
let _e20203 = ((_e20181 * _e639) - (_e20182 * _e626));
let _e20206 = ((_e20182 * _e613) - (_e20180 * _e639));
let _e20209 = ((_e20180 * _e626) - (_e20181 * _e613));
let _e20214 = (((_e20203 * _e20203) + (_e20206 * _e20206)) + (_e20209 * _e20209));
let _e20217 = (1f / select(1e-9f, _e20214, (_e20214 > 1e-9f)));
let _e20220 = ((_e20190 - (_e20200 * _e20195)) * _e20217);
let _e20223 = (((_e20200 * _e20190) - _e20195) * _e20217);
let _e20229 = -(_e20200);
let _e20232 = global_1.member.member_13.member_2;
let _e20233 = (_e20232 * _e20232);
let _e20237 = ((1f + _e20233) - ((2f * _e20232) * _e20229));
let _e20239 = select(1e-9f, _e20237, (_e20237 > 1e-9f));
let _e20251 = global_1.member.member_13.member_3;
if (_e20251 == 2u) {
let _e20256 = (0.5f - (0.5f * _e20229));
let _e20258 = select(0f, _e20256, (_e20256 > 0f));
let _e20262 = (sqrt(select(0f, _e20258, (_e20258 > 0f))) * 255f);
let _e20263 = (255f - 1f);
let _e20265 = select(0f, _e20262, (_e20262 > 0f));
let _e20267 = select(_e20263, _e20265, (_e20265 < _e20263));
let _e20274 = select(0i, select(select(i32(_e20267), i32(-2147483648), (_e20267 < -2147483600f)), 2147483647i, (_e20267 > 2147483500f)), (_e20267 == _e20267));
let _e20278 = (_e20274 - select(0i, 1i, (_e20267 < f32(_e20274))));
let _e20281 = global_1.member.member_13.member_11;
let _e20282 = bitcast<i32>(_e20281);
let _e20283 = (_e20282 + _e20278);
let _e20285 = (bitcast<i32>(_e265) - 1i);
let _e20287 = select(_e20285, _e20283, (_e20283 < _e20285));
let _e20292 = global_2.member[bitcast<u32>(select(0i, _e20287, (_e20287 > 0i)))];
let _e20294 = (_e20282 + (_e20278 + 1i));
let _e20296 = select(_e20285, _e20294, (_e20294 < _e20285));
let _e20301 = global_2.member[bitcast<u32>(select(0i, _e20296, (_e20296 > 0i)))];
phi_57905_ = (_e20292 + ((_e20301 - _e20292) * (_e20262 - f32(_e20278))));
} else {
phi_57905_ = select(((1f - _e20233) / (_e20239 * sqrt(select(0f, _e20239, (_e20239 > 0f))))), (0.75f * (1f + (_e20229 * _e20229))), (_e20251 == 1u));
}
let _e20308 = phi_57905_;
let _e20311 = (_e20178 * (_e20308 * (0.25f / 3.1415927f)));
let _e20312 = (_e20220 - _e20107);
let _e20315 = (_e20223 + select(0f, _e20312, (_e20312 > 0f)));
let _e20318 = global_1.member.member_13.member_1;
let _e20327 = global_1.member.member_13.member;
let _e20332 = -((_e20327.member * _e20315));
let _e20334 = select(-87f, _e20332, (_e20332 > -87f));
let _e20336 = select(88f, _e20334, (_e20334 < 88f));
let _e20338 = ((_e20336 * 1.442695f) + 0.5f);
let _e20340 = select(-127f, _e20338, (_e20338 > -127f));
let _e20342 = select(128f, _e20340, (_e20340 < 128f));
let _e20349 = select(0i, select(select(i32(_e20342), i32(-2147483648), (_e20342 < -2147483600f)), 2147483647i, (_e20342 > 2147483500f)), (_e20342 == _e20342));
let _e20353 = (_e20349 - select(0i, 1i, (_e20342 < f32(_e20349))));
let _e20354 = f32(_e20353);
let _e20358 = ((_e20336 - (_e20354 * 0.6933594f)) - (_e20354 * -2.1219444e-4f));
let _e20380 = -((_e20327.member_1 * _e20315));
let _e20382 = select(-87f, _e20380, (_e20380 > -87f));
let _e20384 = select(88f, _e20382, (_e20382 < 88f));
let _e20386 = ((_e20384 * 1.442695f) + 0.5f);
let _e20388 = select(-127f, _e20386, (_e20386 > -127f));
let _e20390 = select(128f, _e20388, (_e20388 < 128f));
let _e20397 = select(0i, select(select(i32(_e20390), i32(-2147483648), (_e20390 < -2147483600f)), 2147483647i, (_e20390 > 2147483500f)), (_e20390 == _e20390));
let _e20401 = (_e20397 - select(0i, 1i, (_e20390 < f32(_e20397))));
let _e20402 = f32(_e20401);
let _e20406 = ((_e20384 - (_e20402 * 0.6933594f)) - (_e20402 * -2.1219444e-4f));
let _e20428 = -((_e20327.member_2 * _e20315));
let _e20430 = select(-87f, _e20428, (_e20428 > -87f));
let _e20432 = select(88f, _e20430, (_e20430 < 88f));
let _e20434 = ((_e20432 * 1.442695f) + 0.5f);
let _e20436 = select(-127f, _e20434, (_e20434 > -127f));
let _e20438 = select(128f, _e20436, (_e20436 < 128f));
let _e20445 = select(0i, select(select(i32(_e20438), i32(-2147483648), (_e20438 < -2147483600f)), 2147483647i, (_e20438 > 2147483500f)), (_e20438 == _e20438));
let _e20449 = (_e20445 - select(0i, 1i, (_e20438 < f32(_e20445))));
let _e20450 = f32(_e20449);
let _e20454 = ((_e20432 - (_e20450 * 0.6933594f)) - (_e20450 * -2.1219444e-4f));
let _e20481 = select(0f, _e20220, (((_e20223 >= 0f) && (_e20223 < _e691)) && (_e20220 > 0f)));
let _e20484 = ((_e20481 > 0f) && (_e20481 < _e20050));
if _e453 {
phi_58171_ = type_23(_e19950, _e19854);
} else {
phi_58171_ = type_23(_e19854, _e19950);
}
let _e20508 = phi_58171_;
let _e20511 = (_e19951 && _e20484);
let _e20514 = global_1.member.member_18.member;
let _e20515 = (((select(_e19976, (1f - _e19976), (_e19961 >= 0f)) - select(_e19995, (1f - _e19995), (_e19980 >= 0f))) * (1f / _e19958)) * _e20514);
let _e20519 = select(0f, ((((_e652 * _e20318.member) * ((1f + (_e20358 * (1f + (_e20358 * (0.5f + (_e20358 * (0.16666667f + (_e20358 * (0.041666668f + (_e20358 * (0.008333334f + (_e20358 * (0.001388889f + (_e20358 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20353 + 127i)) << bitcast<u32>(23i))))) * _e20311) * _e20515), _e20511);
let _e20520 = select(0f, ((((_e665 * _e20318.member_1) * ((1f + (_e20406 * (1f + (_e20406 * (0.5f + (_e20406 * (0.16666667f + (_e20406 * (0.041666668f + (_e20406 * (0.008333334f + (_e20406 * (0.001388889f + (_e20406 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20401 + 127i)) << bitcast<u32>(23i))))) * _e20311) * _e20515), _e20511);
let _e20521 = select(0f, ((((_e678 * _e20318.member_2) * ((1f + (_e20454 * (1f + (_e20454 * (0.5f + (_e20454 * (0.16666667f + (_e20454 * (0.041666668f + (_e20454 * (0.008333334f + (_e20454 * (0.001388889f + (_e20454 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20449 + 127i)) << bitcast<u32>(23i))))) * _e20311) * _e20515), _e20511);
let _e20525 = (bitcast<f32>((bitcast<u32>(_e20519) & 2147483647u)) >= 1073741800f);
let _e20526 = (1f / 1048576f);
let _e20529 = ((_e20519 * select(1f, _e20526, _e20525)) + 0.5f);
let _e20531 = select(-1073741800f, _e20529, (_e20529 > -1073741800f));
let _e20533 = select(1073741800f, _e20531, (_e20531 < 1073741800f));
let _e20540 = select(0i, select(select(i32(_e20533), i32(-2147483648), (_e20533 < -2147483600f)), 2147483647i, (_e20533 > 2147483500f)), (_e20533 == _e20533));
let _e20544 = (_e20540 - select(0i, 1i, (_e20533 < f32(_e20540))));
let _e20545 = select(0i, 20i, _e20525);
let _e20549 = (bitcast<u32>(_e20544) << bitcast<u32>((_e20545 & 31i)));
let _e20556 = bitcast<u32>(((_e20544 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e20545) & 31i))));
let _e20560 = (bitcast<f32>((bitcast<u32>(_e20520) & 2147483647u)) >= 1073741800f);
let _e20563 = ((_e20520 * select(1f, _e20526, _e20560)) + 0.5f);
let _e20565 = select(-1073741800f, _e20563, (_e20563 > -1073741800f));
let _e20567 = select(1073741800f, _e20565, (_e20565 < 1073741800f));
let _e20574 = select(0i, select(select(i32(_e20567), i32(-2147483648), (_e20567 < -2147483600f)), 2147483647i, (_e20567 > 2147483500f)), (_e20567 == _e20567));
let _e20578 = (_e20574 - select(0i, 1i, (_e20567 < f32(_e20574))));
let _e20579 = select(0i, 20i, _e20560);
let _e20583 = (bitcast<u32>(_e20578) << bitcast<u32>((_e20579 & 31i)));
let _e20590 = bitcast<u32>(((_e20578 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e20579) & 31i))));
let _e20594 = (bitcast<f32>((bitcast<u32>(_e20521) & 2147483647u)) >= 1073741800f);
let _e20597 = ((_e20521 * select(1f, _e20526, _e20594)) + 0.5f);
let _e20599 = select(-1073741800f, _e20597, (_e20597 > -1073741800f));
let _e20601 = select(1073741800f, _e20599, (_e20599 < 1073741800f));
let _e20608 = select(0i, select(select(i32(_e20601), i32(-2147483648), (_e20601 < -2147483600f)), 2147483647i, (_e20601 > 2147483500f)), (_e20601 == _e20601));
let _e20612 = (_e20608 - select(0i, 1i, (_e20601 < f32(_e20608))));
let _e20613 = select(0i, 20i, _e20594);
let _e20617 = (bitcast<u32>(_e20612) << bitcast<u32>((_e20613 & 31i)));
let _e20624 = bitcast<u32>(((_e20612 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e20613) & 31i))));
let _e20629 = global_1.member.member_18.member_2;
let _e20632 = global_1.member.member_18.member_3;
let _e20635 = global_1.member.member_18.member_4;
let _e20638 = global_1.member.member_18.member_5;
if _e14816 {
phi_58370_ = 0u;
} else {
if (_e766 == 1u) {
phi_58369_ = _e20629;
} else {
if (_e766 == 2u) {
phi_58368_ = _e20632;
} else {
phi_58368_ = select(_e20638, _e20635, (_e766 == 3u));
}
let _e20644 = phi_58368_;
phi_58369_ = _e20644;
}
let _e20646 = phi_58369_;
phi_58370_ = _e20646;
}
let _e20648 = phi_58370_;
let _e20656 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e20648) + (_e20508.member_1 * _e19823)) + _e20508.member) * 6i)));
if ((_e20549 | _e20556) == 0u) {
} else {
let _e20659 = bitcast<u32>(_e20656);
if (_e20659 < _e270) {
let _e20663 = atomicAdd((&global_8.member[_e20659]), _e20549);
phi_58404_ = _e20663;
} else {
phi_58404_ = 0u;
}
let _e20665 = phi_58404_;
let _e20669 = (_e20556 + select(0u, 1u, ((_e20665 + _e20549) < _e20549)));
if (_e20669 == 0u) {
} else {
let _e20671 = (_e20659 + 1u);
if (_e20671 < _e270) {
let _e20675 = atomicAdd((&global_8.member[_e20671]), _e20669);
}
}
}
if ((_e20583 | _e20590) == 0u) {
} else {
let _e20679 = bitcast<u32>((_e20656 + 2i));
if (_e20679 < _e270) {
let _e20683 = atomicAdd((&global_8.member[_e20679]), _e20583);
phi_58434_ = _e20683;
} else {
phi_58434_ = 0u;
}
let _e20685 = phi_58434_;
let _e20689 = (_e20590 + select(0u, 1u, ((_e20685 + _e20583) < _e20583)));
if (_e20689 == 0u) {
} else {
let _e20691 = (_e20679 + 1u);
if (_e20691 < _e270) {
let _e20695 = atomicAdd((&global_8.member[_e20691]), _e20689);
}
}
}
if ((_e20617 | _e20624) == 0u) {
} else {
let _e20699 = bitcast<u32>((_e20656 + 4i));
if (_e20699 < _e270) {
let _e20703 = atomicAdd((&global_8.member[_e20699]), _e20617);
phi_58464_ = _e20703;
} else {
phi_58464_ = 0u;
}
let _e20705 = phi_58464_;
let _e20709 = (_e20624 + select(0u, 1u, ((_e20705 + _e20617) < _e20617)));
if (_e20709 == 0u) {
} else {
let _e20711 = (_e20699 + 1u);
if (_e20711 < _e270) {
let _e20715 = atomicAdd((&global_8.member[_e20711]), _e20709);
}
}
}
let _e20716 = bitcast<i32>(bitcast<u32>(select(-1i, _e19950, (_e19951 && (!(((_e20484 && !(((((_e19854 * _e19846) == _e298) && (_e847 != _e766)) || ((((_e19854 + 1i) * _e19846) == _e692) && (_e927 != _e766))))) && ((_e20481 * (1f + (0.02f * _e19847))) < _e20071))) && (_e20481 <= _e20060))))));
if (_e20716 >= 0i) {
phi_58501_ = type_23(select(_e19945.member, _e20716, (_e20716 < _e19945.member)), select(_e19945.member_1, _e20716, (_e20716 > _e19945.member_1)));
} else {
phi_58501_ = _e19945;
}
let _e20726 = phi_58501_;
phi_57162_ = _e20726;
phi_57165_ = (_e19947 + 1i);
} else {
phi_57162_ = type_23();
phi_57165_ = i32();
}
let _e20729 = phi_57162_;
let _e20731 = phi_57165_;
continue;
continuing {
phi_57161_ = _e20729;
phi_57164_ = _e20731;
break if !(_e19951);
}
}
let _e26272 = local_242;
phi_57008_ = _e26272;
phi_57011_ = (_e19843 + 1i);
} else {
phi_57008_ = type_23();
phi_57011_ = i32();
}
let _e20735 = phi_57008_;
let _e20737 = phi_57011_;
continue;
continuing {
phi_57007_ = _e20735;
phi_57010_ = _e20737;
break if !(_e19844);
}
}
let _e20740 = local_233;
let _e20743 = local_234;
if (_e20740.member <= _e20743.member_1) {
let _e20748 = ((_e20743.member_1 + 1i) << bitcast<u32>(_e19812));
if (_e20748 <= _e14815) {
phi_58518_ = (_e20748 - 1i);
} else {
phi_58518_ = _e14815;
}
let _e20752 = phi_58518_;
let _e20754 = (_e20740.member << bitcast<u32>(_e19812));
let _e20756 = select(_e847, 0u, (_e847 == _e766));
let _e20760 = select(_e927, 0u, ((_e927 == _e766) || (_e927 == _e847)));
let _e20768 = ((select(0u, 1u, (_e766 > 0u)) + select(0u, 1u, (_e20756 > 0u))) + select(0u, 1u, (_e20760 > 0u)));
if (_e20768 == 0u) {
phi_58553_ = 0i;
loop {
let _e20771 = phi_58553_;
let _e20772 = (_e20771 < 16i);
if _e20772 {
let _e20774 = (_e14810 + (_e20771 & 15i));
let _e20778 = (((f32(_e20774) + 0.5f) * 1f) - 0.5f);
let _e20782 = (-(((_e416 * _e20778) + _e442)) / _e429);
let _e20789 = bitcast<f32>((bitcast<u32>(((_e466 * _e20778) + ((_e479 * _e20782) + _e492))) & 2147483647u));
let _e20796 = bitcast<f32>((bitcast<u32>(((_e505 * _e20778) + ((_e518 * _e20782) + _e531))) & 2147483647u));
let _e20800 = (((0.5f * (_e20789 + _e20796)) / _e534) + _e717);
let _e20801 = (1f / 1f);
let _e20809 = ((((_e20782 + _e20800) + 0.5f) * _e20801) - 0.5f);
let _e20810 = f32(_e20754);
let _e20811 = f32(_e20752);
let _e20812 = (_e20810 - 1f);
let _e20814 = select(_e20812, _e20809, (_e20809 > _e20812));
let _e20816 = select(_e20811, _e20814, (_e20814 < _e20811));
let _e20823 = select(0i, select(select(i32(_e20816), i32(-2147483648), (_e20816 < -2147483600f)), 2147483647i, (_e20816 > 2147483500f)), (_e20816 == _e20816));
let _e20828 = (((((_e20782 - _e20800) + 0.5f) * _e20801) - 0.5f) + 1f);
let _e20829 = (_e20811 + 1f);
let _e20831 = select(_e20810, _e20828, (_e20828 > _e20810));
let _e20833 = select(_e20829, _e20831, (_e20831 < _e20829));
let _e20840 = select(0i, select(select(i32(_e20833), i32(-2147483648), (_e20833 < -2147483600f)), 2147483647i, (_e20833 > 2147483500f)), (_e20833 == _e20833));
let _e20851 = ((1e-4f * 1f) * _e534);
let _e20853 = select(_e20796, _e20789, (_e20789 > _e20796));
let _e20855 = select(_e20851, _e20853, (_e20853 > _e20851));
let _e20857 = select(_e20796, _e20789, (_e20789 < _e20796));
let _e20859 = select(_e20851, _e20857, (_e20857 > _e20851));
let _e20861 = (0.5f * (_e20855 + _e20859));
let _e20862 = (0.5f / _e20859);
let _e20863 = (1f / _e20855);
phi_58707_ = 0i;
loop {
let _e20865 = phi_58707_;
let _e20867 = (((_e20840 - select(0i, 1i, (_e20833 < f32(_e20840)))) + (_e20771 >> bitcast<u32>(4u))) + bitcast<i32>(_e20865));
let _e20868 = (_e20867 <= select(-1i, (_e20823 - select(0i, 1i, (_e20816 < f32(_e20823)))), (_e20774 <= _e14814)));
if _e20868 {
let _e20874 = (((((f32(_e20867) + 0.5f) * 1f) - 0.5f) - _e20782) * _e534);
let _e20875 = (_e534 * 1f);
let _e20877 = (0.5f * _e20875);
let _e20878 = (_e20874 + _e20877);
let _e20879 = -(_e20878);
let _e20882 = (_e20861 - select(_e20879, _e20878, (_e20878 > _e20879)));
let _e20884 = select(0f, _e20882, (_e20882 > 0f));
let _e20886 = select(_e20859, _e20884, (_e20884 < _e20859));
let _e20889 = (_e20882 - _e20859);
let _e20893 = (((_e20886 * (_e20886 * _e20862)) + select(0f, _e20889, (_e20889 > 0f))) * _e20863);
let _e20897 = (_e20874 - _e20877);
let _e20898 = -(_e20897);
let _e20901 = (_e20861 - select(_e20898, _e20897, (_e20897 > _e20898)));
let _e20903 = select(0f, _e20901, (_e20901 > 0f));
let _e20905 = select(_e20859, _e20903, (_e20903 < _e20859));
let _e20908 = (_e20901 - _e20859);
let _e20912 = (((_e20905 * (_e20905 * _e20862)) + select(0f, _e20908, (_e20908 > 0f))) * _e20863);
if _e453 {
phi_58812_ = type_23(_e20867, _e20774);
} else {
phi_58812_ = type_23(_e20774, _e20867);
}
let _e20921 = phi_58812_;
local_36 = bitcast<i32>((_e14761 * _e14764));
local_37 = ((_e20921.member_1 * _e14765) + _e20921.member);
let _e20928 = local_36;
let _e20929 = local_37;
let _e20930 = (_e20928 + _e20929);
let _e20932 = (bitcast<i32>(_e259) - 1i);
let _e20934 = select(_e20932, _e20930, (_e20930 < _e20932));
let _e20939 = global_5.member[bitcast<u32>(select(0i, _e20934, (_e20934 > 0i)))];
let _e20940 = local_37;
let _e20942 = select(_e20932, _e20940, (_e20940 < _e20932));
let _e20947 = global_5.member[bitcast<u32>(select(0i, _e20942, (_e20942 > 0i)))];
let _e20958 = global_1.member.member_2.member;
let _e20959 = (((((f32(_e20921.member) + 0.5f) / f32(_e14765)) * 2f) - 1f) * _e20958);
let _e20966 = global_1.member.member_2.member_1;
let _e20967 = ((1f - (((f32(_e20921.member_1) + 0.5f) / f32(_e14766)) * 2f)) * _e20966);
let _e20969 = global_1.member.member_3;
let _e20977 = global_1.member.member_4;
let _e20984 = ((_e20969.member * _e20959) + (_e20977.member * _e20967));
let _e20985 = ((_e20969.member_1 * _e20959) + (_e20977.member_1 * _e20967));
let _e20986 = ((_e20969.member_2 * _e20959) + (_e20977.member_2 * _e20967));
let _e20989 = global_1.member.member_2.member_3;
let _e20990 = (_e20989 != 0u);
let _e20992 = global_1.member.member_5;
let _e20999 = select((_e20992.member + _e20984), _e20992.member, _e20990);
let _e21000 = select((_e20992.member_1 + _e20985), _e20992.member_1, _e20990);
let _e21001 = select((_e20992.member_2 + _e20986), _e20992.member_2, _e20990);
let _e21003 = global_1.member.member_6;
let _e21017 = (((_e20999 * _e20999) + (_e21000 * _e21000)) + (_e21001 * _e21001));
let _e21020 = sqrt(select(0f, _e21017, (_e21017 > 0f)));
let _e21021 = (1f / _e21020);
let _e21022 = (_e20999 * _e21021);
let _e21023 = (_e21000 * _e21021);
let _e21024 = (_e21001 * _e21021);
let _e21025 = (_e575 - select(_e21003.member, (_e21003.member + _e20984), _e20990));
let _e21026 = (_e587 - select(_e21003.member_1, (_e21003.member_1 + _e20985), _e20990));
let _e21027 = (_e600 - select(_e21003.member_2, (_e21003.member_2 + _e20986), _e20990));
let _e21032 = (((_e21025 * _e21022) + (_e21026 * _e21023)) + (_e21027 * _e21024));
let _e21037 = (((_e21025 * _e613) + (_e21026 * _e626)) + (_e21027 * _e639));
let _e21042 = (((_e21022 * _e613) + (_e21023 * _e626)) + (_e21024 * _e639));
let _e21045 = ((_e21023 * _e639) - (_e21024 * _e626));
let _e21048 = ((_e21024 * _e613) - (_e21022 * _e639));
let _e21051 = ((_e21022 * _e626) - (_e21023 * _e613));
let _e21056 = (((_e21045 * _e21045) + (_e21048 * _e21048)) + (_e21051 * _e21051));
let _e21059 = (1f / select(1e-9f, _e21056, (_e21056 > 1e-9f)));
let _e21062 = ((_e21032 - (_e21042 * _e21037)) * _e21059);
let _e21065 = (((_e21042 * _e21032) - _e21037) * _e21059);
let _e21071 = -(_e21042);
let _e21074 = global_1.member.member_13.member_2;
let _e21075 = (_e21074 * _e21074);
let _e21079 = ((1f + _e21075) - ((2f * _e21074) * _e21071));
let _e21081 = select(1e-9f, _e21079, (_e21079 > 1e-9f));
let _e21093 = global_1.member.member_13.member_3;
if (_e21093 == 2u) {
let _e21098 = (0.5f - (0.5f * _e21071));
let _e21100 = select(0f, _e21098, (_e21098 > 0f));
let _e21104 = (sqrt(select(0f, _e21100, (_e21100 > 0f))) * 255f);
let _e21105 = (255f - 1f);
let _e21107 = select(0f, _e21104, (_e21104 > 0f));
let _e21109 = select(_e21105, _e21107, (_e21107 < _e21105));
let _e21116 = select(0i, select(select(i32(_e21109), i32(-2147483648), (_e21109 < -2147483600f)), 2147483647i, (_e21109 > 2147483500f)), (_e21109 == _e21109));
let _e21120 = (_e21116 - select(0i, 1i, (_e21109 < f32(_e21116))));
let _e21123 = global_1.member.member_13.member_11;
let _e21124 = bitcast<i32>(_e21123);
let _e21125 = (_e21124 + _e21120);
let _e21127 = (bitcast<i32>(_e265) - 1i);
let _e21129 = select(_e21127, _e21125, (_e21125 < _e21127));
let _e21134 = global_2.member[bitcast<u32>(select(0i, _e21129, (_e21129 > 0i)))];
let _e21136 = (_e21124 + (_e21120 + 1i));
let _e21138 = select(_e21127, _e21136, (_e21136 < _e21127));
let _e21143 = global_2.member[bitcast<u32>(select(0i, _e21138, (_e21138 > 0i)))];
phi_59239_ = (_e21134 + ((_e21143 - _e21134) * (_e21104 - f32(_e21120))));
} else {
phi_59239_ = select(((1f - _e21075) / (_e21081 * sqrt(select(0f, _e21081, (_e21081 > 0f))))), (0.75f * (1f + (_e21071 * _e21071))), (_e21093 == 1u));
}
let _e21150 = phi_59239_;
let _e21153 = (_e21020 * (_e21150 * (0.25f / 3.1415927f)));
let _e21154 = (_e21062 - _e20939);
let _e21157 = (_e21065 + select(0f, _e21154, (_e21154 > 0f)));
let _e21160 = global_1.member.member_13.member_1;
let _e21169 = global_1.member.member_13.member;
let _e21174 = -((_e21169.member * _e21157));
let _e21176 = select(-87f, _e21174, (_e21174 > -87f));
let _e21178 = select(88f, _e21176, (_e21176 < 88f));
let _e21180 = ((_e21178 * 1.442695f) + 0.5f);
let _e21182 = select(-127f, _e21180, (_e21180 > -127f));
let _e21184 = select(128f, _e21182, (_e21182 < 128f));
let _e21191 = select(0i, select(select(i32(_e21184), i32(-2147483648), (_e21184 < -2147483600f)), 2147483647i, (_e21184 > 2147483500f)), (_e21184 == _e21184));
let _e21195 = (_e21191 - select(0i, 1i, (_e21184 < f32(_e21191))));
let _e21196 = f32(_e21195);
let _e21200 = ((_e21178 - (_e21196 * 0.6933594f)) - (_e21196 * -2.1219444e-4f));
let _e21222 = -((_e21169.member_1 * _e21157));
let _e21224 = select(-87f, _e21222, (_e21222 > -87f));
let _e21226 = select(88f, _e21224, (_e21224 < 88f));
let _e21228 = ((_e21226 * 1.442695f) + 0.5f);
let _e21230 = select(-127f, _e21228, (_e21228 > -127f));
let _e21232 = select(128f, _e21230, (_e21230 < 128f));
let _e21239 = select(0i, select(select(i32(_e21232), i32(-2147483648), (_e21232 < -2147483600f)), 2147483647i, (_e21232 > 2147483500f)), (_e21232 == _e21232));
let _e21243 = (_e21239 - select(0i, 1i, (_e21232 < f32(_e21239))));
let _e21244 = f32(_e21243);
let _e21248 = ((_e21226 - (_e21244 * 0.6933594f)) - (_e21244 * -2.1219444e-4f));
let _e21270 = -((_e21169.member_2 * _e21157));
let _e21272 = select(-87f, _e21270, (_e21270 > -87f));
let _e21274 = select(88f, _e21272, (_e21272 < 88f));
let _e21276 = ((_e21274 * 1.442695f) + 0.5f);
let _e21278 = select(-127f, _e21276, (_e21276 > -127f));
let _e21280 = select(128f, _e21278, (_e21278 < 128f));
let _e21287 = select(0i, select(select(i32(_e21280), i32(-2147483648), (_e21280 < -2147483600f)), 2147483647i, (_e21280 > 2147483500f)), (_e21280 == _e21280));
let _e21291 = (_e21287 - select(0i, 1i, (_e21280 < f32(_e21287))));
let _e21292 = f32(_e21291);
let _e21296 = ((_e21274 - (_e21292 * 0.6933594f)) - (_e21292 * -2.1219444e-4f));
let _e21323 = select(0f, _e21062, (((_e21065 >= 0f) && (_e21065 < _e691)) && (_e21062 > 0f)));
if _e453 {
phi_59484_ = type_23(_e20867, _e20774);
} else {
phi_59484_ = type_23(_e20774, _e20867);
}
let _e21334 = phi_59484_;
let _e21337 = (_e20868 && (((_e21323 > 0f) && (_e21323 < _e20947)) && true));
let _e21340 = global_1.member.member_18.member;
let _e21341 = (((select(_e20893, (1f - _e20893), (_e20878 >= 0f)) - select(_e20912, (1f - _e20912), (_e20897 >= 0f))) * (1f / _e20875)) * _e21340);
let _e21345 = select(0f, (((((_e652 * _e21160.member) * ((1f + (_e21200 * (1f + (_e21200 * (0.5f + (_e21200 * (0.16666667f + (_e21200 * (0.041666668f + (_e21200 * (0.008333334f + (_e21200 * (0.001388889f + (_e21200 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21195 + 127i)) << bitcast<u32>(23i))))) * _e21153) * 1f) * _e21341), _e21337);
let _e21346 = select(0f, (((((_e665 * _e21160.member_1) * ((1f + (_e21248 * (1f + (_e21248 * (0.5f + (_e21248 * (0.16666667f + (_e21248 * (0.041666668f + (_e21248 * (0.008333334f + (_e21248 * (0.001388889f + (_e21248 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21243 + 127i)) << bitcast<u32>(23i))))) * _e21153) * 1f) * _e21341), _e21337);
let _e21347 = select(0f, (((((_e678 * _e21160.member_2) * ((1f + (_e21296 * (1f + (_e21296 * (0.5f + (_e21296 * (0.16666667f + (_e21296 * (0.041666668f + (_e21296 * (0.008333334f + (_e21296 * (0.001388889f + (_e21296 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21291 + 127i)) << bitcast<u32>(23i))))) * _e21153) * 1f) * _e21341), _e21337);
let _e21351 = (bitcast<f32>((bitcast<u32>(_e21345) & 2147483647u)) >= 1073741800f);
let _e21352 = (1f / 1048576f);
let _e21355 = ((_e21345 * select(1f, _e21352, _e21351)) + 0.5f);
let _e21357 = select(-1073741800f, _e21355, (_e21355 > -1073741800f));
let _e21359 = select(1073741800f, _e21357, (_e21357 < 1073741800f));
let _e21366 = select(0i, select(select(i32(_e21359), i32(-2147483648), (_e21359 < -2147483600f)), 2147483647i, (_e21359 > 2147483500f)), (_e21359 == _e21359));
let _e21370 = (_e21366 - select(0i, 1i, (_e21359 < f32(_e21366))));
let _e21371 = select(0i, 20i, _e21351);
let _e21375 = (bitcast<u32>(_e21370) << bitcast<u32>((_e21371 & 31i)));
let _e21382 = bitcast<u32>(((_e21370 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e21371) & 31i))));
let _e21386 = (bitcast<f32>((bitcast<u32>(_e21346) & 2147483647u)) >= 1073741800f);
let _e21389 = ((_e21346 * select(1f, _e21352, _e21386)) + 0.5f);
let _e21391 = select(-1073741800f, _e21389, (_e21389 > -1073741800f));
let _e21393 = select(1073741800f, _e21391, (_e21391 < 1073741800f));
let _e21400 = select(0i, select(select(i32(_e21393), i32(-2147483648), (_e21393 < -2147483600f)), 2147483647i, (_e21393 > 2147483500f)), (_e21393 == _e21393));
let _e21404 = (_e21400 - select(0i, 1i, (_e21393 < f32(_e21400))));
let _e21405 = select(0i, 20i, _e21386);
let _e21409 = (bitcast<u32>(_e21404) << bitcast<u32>((_e21405 & 31i)));
let _e21416 = bitcast<u32>(((_e21404 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e21405) & 31i))));
let _e21420 = (bitcast<f32>((bitcast<u32>(_e21347) & 2147483647u)) >= 1073741800f);
let _e21423 = ((_e21347 * select(1f, _e21352, _e21420)) + 0.5f);
let _e21425 = select(-1073741800f, _e21423, (_e21423 > -1073741800f));
let _e21427 = select(1073741800f, _e21425, (_e21425 < 1073741800f));
let _e21434 = select(0i, select(select(i32(_e21427), i32(-2147483648), (_e21427 < -2147483600f)), 2147483647i, (_e21427 > 2147483500f)), (_e21427 == _e21427));
let _e21438 = (_e21434 - select(0i, 1i, (_e21427 < f32(_e21434))));
let _e21439 = select(0i, 20i, _e21420);
let _e21443 = (bitcast<u32>(_e21438) << bitcast<u32>((_e21439 & 31i)));
let _e21450 = bitcast<u32>(((_e21438 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e21439) & 31i))));
let _e21455 = bitcast<i32>(bitcast<u32>((((_e21334.member_1 * _e14765) + _e21334.member) * 6i)));
if ((_e21375 | _e21382) == 0u) {
} else {
let _e21458 = bitcast<u32>(_e21455);
if (_e21458 < _e270) {
let _e21462 = atomicAdd((&global_8.member[_e21458]), _e21375);
phi_59717_ = _e21462;
} else {
phi_59717_ = 0u;
}
let _e21464 = phi_59717_;
let _e21468 = (_e21382 + select(0u, 1u, ((_e21464 + _e21375) < _e21375)));
if (_e21468 == 0u) {
} else {
let _e21470 = (_e21458 + 1u);
if (_e21470 < _e270) {
let _e21474 = atomicAdd((&global_8.member[_e21470]), _e21468);
}
}
}
if ((_e21409 | _e21416) == 0u) {
} else {
let _e21478 = bitcast<u32>((_e21455 + 2i));
if (_e21478 < _e270) {
let _e21482 = atomicAdd((&global_8.member[_e21478]), _e21409);
phi_59747_ = _e21482;
} else {
phi_59747_ = 0u;
}
let _e21484 = phi_59747_;
let _e21488 = (_e21416 + select(0u, 1u, ((_e21484 + _e21409) < _e21409)));
if (_e21488 == 0u) {
} else {
let _e21490 = (_e21478 + 1u);
if (_e21490 < _e270) {
let _e21494 = atomicAdd((&global_8.member[_e21490]), _e21488);
}
}
}
if ((_e21443 | _e21450) == 0u) {
} else {
let _e21498 = bitcast<u32>((_e21455 + 4i));
if (_e21498 < _e270) {
let _e21502 = atomicAdd((&global_8.member[_e21498]), _e21443);
phi_59777_ = _e21502;
} else {
phi_59777_ = 0u;
}
let _e21504 = phi_59777_;
let _e21508 = (_e21450 + select(0u, 1u, ((_e21504 + _e21443) < _e21443)));
if (_e21508 == 0u) {
} else {
let _e21510 = (_e21498 + 1u);
if (_e21510 < _e270) {
let _e21514 = atomicAdd((&global_8.member[_e21510]), _e21508);
}
}
}
phi_58708_ = (_e20865 + 1i);
} else {
phi_58708_ = i32();
}
let _e21517 = phi_58708_;
continue;
continuing {
phi_58707_ = _e21517;
break if !(_e20868);
}
}
phi_58554_ = (_e20771 + 1i);
} else {
phi_58554_ = i32();
}
let _e21521 = phi_58554_;
continue;
continuing {
phi_58553_ = _e21521;
break if !(_e20772);
}
}
} else {
if (_e20768 == 1u) {
phi_59826_ = 0i;
loop {
let _e21525 = phi_59826_;
let _e21526 = (_e21525 < 16i);
if _e21526 {
let _e21528 = (_e14810 + (_e21525 & 15i));
let _e21530 = (f32(_e21528) + 0.5f);
let _e21532 = ((_e21530 * 1f) - 0.5f);
let _e21536 = (-(((_e416 * _e21532) + _e442)) / _e429);
let _e21543 = bitcast<f32>((bitcast<u32>(((_e466 * _e21532) + ((_e479 * _e21536) + _e492))) & 2147483647u));
let _e21550 = bitcast<f32>((bitcast<u32>(((_e505 * _e21532) + ((_e518 * _e21536) + _e531))) & 2147483647u));
let _e21554 = (((0.5f * (_e21543 + _e21550)) / _e534) + _e717);
let _e21555 = (1f / 1f);
let _e21563 = ((((_e21536 + _e21554) + 0.5f) * _e21555) - 0.5f);
let _e21564 = f32(_e20754);
let _e21565 = f32(_e20752);
let _e21566 = (_e21564 - 1f);
let _e21568 = select(_e21566, _e21563, (_e21563 > _e21566));
let _e21570 = select(_e21565, _e21568, (_e21568 < _e21565));
let _e21577 = select(0i, select(select(i32(_e21570), i32(-2147483648), (_e21570 < -2147483600f)), 2147483647i, (_e21570 > 2147483500f)), (_e21570 == _e21570));
let _e21582 = (((((_e21536 - _e21554) + 0.5f) * _e21555) - 0.5f) + 1f);
let _e21583 = (_e21565 + 1f);
let _e21585 = select(_e21564, _e21582, (_e21582 > _e21564));
let _e21587 = select(_e21583, _e21585, (_e21585 < _e21583));
let _e21594 = select(0i, select(select(i32(_e21587), i32(-2147483648), (_e21587 < -2147483600f)), 2147483647i, (_e21587 > 2147483500f)), (_e21587 == _e21587));
let _e21605 = ((1e-4f * 1f) * _e534);
let _e21607 = select(_e21550, _e21543, (_e21543 > _e21550));
let _e21609 = select(_e21605, _e21607, (_e21607 > _e21605));
let _e21611 = select(_e21550, _e21543, (_e21543 < _e21550));
let _e21613 = select(_e21605, _e21611, (_e21611 > _e21605));
let _e21615 = (0.5f * (_e21609 + _e21613));
let _e21616 = (0.5f / _e21613);
let _e21617 = (1f / _e21609);
phi_59980_ = 0i;
loop {
let _e21619 = phi_59980_;
let _e21621 = (((_e21594 - select(0i, 1i, (_e21587 < f32(_e21594)))) + (_e21525 >> bitcast<u32>(4u))) + bitcast<i32>(_e21619));
let _e21622 = (_e21621 <= select(-1i, (_e21577 - select(0i, 1i, (_e21570 < f32(_e21577)))), (_e21528 <= _e14814)));
if _e21622 {
let _e21624 = (f32(_e21621) + 0.5f);
let _e21628 = ((((_e21624 * 1f) - 0.5f) - _e21536) * _e534);
let _e21629 = (_e534 * 1f);
let _e21631 = (0.5f * _e21629);
let _e21632 = (_e21628 + _e21631);
let _e21633 = -(_e21632);
let _e21636 = (_e21615 - select(_e21633, _e21632, (_e21632 > _e21633)));
let _e21638 = select(0f, _e21636, (_e21636 > 0f));
let _e21640 = select(_e21613, _e21638, (_e21638 < _e21613));
let _e21643 = (_e21636 - _e21613);
let _e21647 = (((_e21640 * (_e21640 * _e21616)) + select(0f, _e21643, (_e21643 > 0f))) * _e21617);
let _e21651 = (_e21628 - _e21631);
let _e21652 = -(_e21651);
let _e21655 = (_e21615 - select(_e21652, _e21651, (_e21651 > _e21652)));
let _e21657 = select(0f, _e21655, (_e21655 > 0f));
let _e21659 = select(_e21613, _e21657, (_e21657 < _e21613));
let _e21662 = (_e21655 - _e21613);
let _e21666 = (((_e21659 * (_e21659 * _e21616)) + select(0f, _e21662, (_e21662 > 0f))) * _e21617);
if _e453 {
phi_60085_ = type_23(_e21621, _e21528);
} else {
phi_60085_ = type_23(_e21528, _e21621);
}
let _e21675 = phi_60085_;
local_34 = bitcast<i32>((_e14761 * _e14764));
local_35 = ((_e21675.member_1 * _e14765) + _e21675.member);
let _e21682 = local_34;
let _e21683 = local_35;
let _e21684 = (_e21682 + _e21683);
let _e21686 = (bitcast<i32>(_e259) - 1i);
let _e21688 = select(_e21686, _e21684, (_e21684 < _e21686));
let _e21693 = global_5.member[bitcast<u32>(select(0i, _e21688, (_e21688 > 0i)))];
let _e21694 = local_35;
let _e21696 = select(_e21686, _e21694, (_e21694 < _e21686));
let _e21701 = global_5.member[bitcast<u32>(select(0i, _e21696, (_e21696 > 0i)))];
let _e21704 = f32(_e14765);
let _e21705 = f32(_e14766);
let _e21712 = global_1.member.member_2.member;
let _e21713 = (((((f32(_e21675.member) + 0.5f) / _e21704) * 2f) - 1f) * _e21712);
let _e21720 = global_1.member.member_2.member_1;
let _e21721 = ((1f - (((f32(_e21675.member_1) + 0.5f) / _e21705) * 2f)) * _e21720);
let _e21723 = global_1.member.member_3;
let _e21731 = global_1.member.member_4;
let _e21738 = ((_e21723.member * _e21713) + (_e21731.member * _e21721));
let _e21739 = ((_e21723.member_1 * _e21713) + (_e21731.member_1 * _e21721));
let _e21740 = ((_e21723.member_2 * _e21713) + (_e21731.member_2 * _e21721));
let _e21743 = global_1.member.member_2.member_3;
let _e21744 = (_e21743 != 0u);
let _e21746 = global_1.member.member_5;
let _e21753 = select((_e21746.member + _e21738), _e21746.member, _e21744);
let _e21754 = select((_e21746.member_1 + _e21739), _e21746.member_1, _e21744);
let _e21755 = select((_e21746.member_2 + _e21740), _e21746.member_2, _e21744);
let _e21757 = global_1.member.member_6;
let _e21771 = (((_e21753 * _e21753) + (_e21754 * _e21754)) + (_e21755 * _e21755));
let _e21774 = sqrt(select(0f, _e21771, (_e21771 > 0f)));
let _e21775 = (1f / _e21774);
let _e21776 = (_e21753 * _e21775);
let _e21777 = (_e21754 * _e21775);
let _e21778 = (_e21755 * _e21775);
let _e21779 = (_e575 - select(_e21757.member, (_e21757.member + _e21738), _e21744));
let _e21780 = (_e587 - select(_e21757.member_1, (_e21757.member_1 + _e21739), _e21744));
let _e21781 = (_e600 - select(_e21757.member_2, (_e21757.member_2 + _e21740), _e21744));
let _e21786 = (((_e21779 * _e21776) + (_e21780 * _e21777)) + (_e21781 * _e21778));
let _e21791 = (((_e21779 * _e613) + (_e21780 * _e626)) + (_e21781 * _e639));
let _e21796 = (((_e21776 * _e613) + (_e21777 * _e626)) + (_e21778 * _e639));
let _e21799 = ((_e21777 * _e639) - (_e21778 * _e626));
let _e21802 = ((_e21778 * _e613) - (_e21776 * _e639));
let _e21805 = ((_e21776 * _e626) - (_e21777 * _e613));
let _e21810 = (((_e21799 * _e21799) + (_e21802 * _e21802)) + (_e21805 * _e21805));
let _e21813 = (1f / select(1e-9f, _e21810, (_e21810 > 1e-9f)));
let _e21816 = ((_e21786 - (_e21796 * _e21791)) * _e21813);
let _e21819 = (((_e21796 * _e21786) - _e21791) * _e21813);
let _e21825 = -(_e21796);
let _e21828 = global_1.member.member_13.member_2;
let _e21829 = (_e21828 * _e21828);
let _e21833 = ((1f + _e21829) - ((2f * _e21828) * _e21825));
let _e21835 = select(1e-9f, _e21833, (_e21833 > 1e-9f));
let _e21847 = global_1.member.member_13.member_3;
if (_e21847 == 2u) {
let _e21852 = (0.5f - (0.5f * _e21825));
let _e21854 = select(0f, _e21852, (_e21852 > 0f));
let _e21858 = (sqrt(select(0f, _e21854, (_e21854 > 0f))) * 255f);
let _e21859 = (255f - 1f);
let _e21861 = select(0f, _e21858, (_e21858 > 0f));
let _e21863 = select(_e21859, _e21861, (_e21861 < _e21859));
let _e21870 = select(0i, select(select(i32(_e21863), i32(-2147483648), (_e21863 < -2147483600f)), 2147483647i, (_e21863 > 2147483500f)), (_e21863 == _e21863));
let _e21874 = (_e21870 - select(0i, 1i, (_e21863 < f32(_e21870))));
let _e21877 = global_1.member.member_13.member_11;
let _e21878 = bitcast<i32>(_e21877);
let _e21879 = (_e21878 + _e21874);
let _e21881 = (bitcast<i32>(_e265) - 1i);
let _e21883 = select(_e21881, _e21879, (_e21879 < _e21881));
let _e21888 = global_2.member[bitcast<u32>(select(0i, _e21883, (_e21883 > 0i)))];
let _e21890 = (_e21878 + (_e21874 + 1i));
let _e21892 = select(_e21881, _e21890, (_e21890 < _e21881));
let _e21897 = global_2.member[bitcast<u32>(select(0i, _e21892, (_e21892 > 0i)))];
phi_60512_ = (_e21888 + ((_e21897 - _e21888) * (_e21858 - f32(_e21874))));
} else {
phi_60512_ = select(((1f - _e21829) / (_e21835 * sqrt(select(0f, _e21835, (_e21835 > 0f))))), (0.75f * (1f + (_e21825 * _e21825))), (_e21847 == 1u));
}
let _e21904 = phi_60512_;
let _e21907 = (_e21774 * (_e21904 * (0.25f / 3.1415927f)));
let _e21908 = (_e21816 - _e21693);
let _e21911 = (_e21819 + select(0f, _e21908, (_e21908 > 0f)));
let _e21914 = global_1.member.member_13.member_1;
let _e21923 = global_1.member.member_13.member;
let _e21928 = -((_e21923.member * _e21911));
let _e21930 = select(-87f, _e21928, (_e21928 > -87f));
let _e21932 = select(88f, _e21930, (_e21930 < 88f));
let _e21934 = ((_e21932 * 1.442695f) + 0.5f);
let _e21936 = select(-127f, _e21934, (_e21934 > -127f));
let _e21938 = select(128f, _e21936, (_e21936 < 128f));
let _e21945 = select(0i, select(select(i32(_e21938), i32(-2147483648), (_e21938 < -2147483600f)), 2147483647i, (_e21938 > 2147483500f)), (_e21938 == _e21938));
let _e21949 = (_e21945 - select(0i, 1i, (_e21938 < f32(_e21945))));
let _e21950 = f32(_e21949);
let _e21954 = ((_e21932 - (_e21950 * 0.6933594f)) - (_e21950 * -2.1219444e-4f));
let _e21976 = -((_e21923.member_1 * _e21911));
let _e21978 = select(-87f, _e21976, (_e21976 > -87f));
let _e21980 = select(88f, _e21978, (_e21978 < 88f));
let _e21982 = ((_e21980 * 1.442695f) + 0.5f);
let _e21984 = select(-127f, _e21982, (_e21982 > -127f));
let _e21986 = select(128f, _e21984, (_e21984 < 128f));
let _e21993 = select(0i, select(select(i32(_e21986), i32(-2147483648), (_e21986 < -2147483600f)), 2147483647i, (_e21986 > 2147483500f)), (_e21986 == _e21986));
let _e21997 = (_e21993 - select(0i, 1i, (_e21986 < f32(_e21993))));
let _e21998 = f32(_e21997);
let _e22002 = ((_e21980 - (_e21998 * 0.6933594f)) - (_e21998 * -2.1219444e-4f));
let _e22024 = -((_e21923.member_2 * _e21911));
let _e22026 = select(-87f, _e22024, (_e22024 > -87f));
let _e22028 = select(88f, _e22026, (_e22026 < 88f));
let _e22030 = ((_e22028 * 1.442695f) + 0.5f);
let _e22032 = select(-127f, _e22030, (_e22030 > -127f));
let _e22034 = select(128f, _e22032, (_e22032 < 128f));
let _e22041 = select(0i, select(select(i32(_e22034), i32(-2147483648), (_e22034 < -2147483600f)), 2147483647i, (_e22034 > 2147483500f)), (_e22034 == _e22034));
let _e22045 = (_e22041 - select(0i, 1i, (_e22034 < f32(_e22041))));
let _e22046 = f32(_e22045);
let _e22050 = ((_e22028 - (_e22046 * 0.6933594f)) - (_e22046 * -2.1219444e-4f));
let _e22077 = select(0f, _e21816, (((_e21819 >= 0f) && (_e21819 < _e691)) && (_e21816 > 0f)));
let _e22079 = ((_e766 + _e20756) + _e20760);
let _e22080 = (_e22079 & 31u);
let _e22082 = (1u << bitcast<u32>(_e22080));
let _e22091 = bitcast<i32>((((_e14761 + _e22082) - 1u) >> bitcast<u32>(_e22080)));
let _e22092 = bitcast<i32>((((_e14764 + _e22082) - 1u) >> bitcast<u32>(_e22080)));
if _e453 {
phi_60783_ = type_23(_e22092, _e22091);
} else {
phi_60783_ = type_23(_e22091, _e22092);
}
let _e22096 = phi_60783_;
let _e22101 = f32((1i << bitcast<u32>(_e22080)));
let _e22102 = (1f / _e22101);
let _e22104 = ((_e21530 * _e22102) - 0.5f);
let _e22106 = ((_e21624 * _e22102) - 0.5f);
let _e22108 = select(-1f, _e22104, (_e22104 > -1f));
let _e22110 = select(1e6f, _e22108, (_e22108 < 1e6f));
let _e22117 = select(0i, select(select(i32(_e22110), i32(-2147483648), (_e22110 < -2147483600f)), 2147483647i, (_e22110 > 2147483500f)), (_e22110 == _e22110));
let _e22121 = (_e22117 - select(0i, 1i, (_e22110 < f32(_e22117))));
let _e22123 = select(-1f, _e22106, (_e22106 > -1f));
let _e22125 = select(1e6f, _e22123, (_e22123 < 1e6f));
let _e22132 = select(0i, select(select(i32(_e22125), i32(-2147483648), (_e22125 < -2147483600f)), 2147483647i, (_e22125 > 2147483500f)), (_e22125 == _e22125));
let _e22136 = (_e22132 - select(0i, 1i, (_e22125 < f32(_e22132))));
let _e22138 = (_e22104 - f32(_e22121));
let _e22140 = (_e22106 - f32(_e22136));
let _e22141 = (1f - _e22138);
let _e22142 = (1f - _e22140);
let _e22145 = select(_e22121, 0i, (_e22121 < 0i));
let _e22146 = (_e22145 >= _e22096.member);
if _e22146 {
phi_60861_ = (_e22096.member - 1i);
} else {
phi_60861_ = _e22145;
}
let _e22149 = phi_60861_;
let _e22151 = select(_e22136, 0i, (_e22136 < 0i));
let _e22152 = (_e22151 >= _e22096.member_1);
if _e22152 {
phi_60872_ = (_e22096.member_1 - 1i);
} else {
phi_60872_ = _e22151;
}
let _e22155 = phi_60872_;
let _e22159 = (((f32(_e22149) + 0.5f) * _e22101) - 0.5f);
let _e22163 = (((f32(_e22155) + 0.5f) * _e22101) - 0.5f);
if _e453 {
phi_60900_ = type_23(_e22155, _e22149);
} else {
phi_60900_ = type_23(_e22149, _e22155);
}
let _e22169 = phi_60900_;
let _e22175 = bitcast<i32>(((_e14761 + 1u) >> bitcast<u32>(1u)));
let _e22178 = global_1.member.member_18.member_6;
let _e22181 = global_1.member.member_18.member_7;
let _e22184 = global_1.member.member_18.member_8;
let _e22185 = (_e22079 == 0u);
if _e22185 {
phi_60951_ = 0u;
} else {
if (_e22079 == 1u) {
phi_60950_ = 0u;
} else {
if (_e22079 == 2u) {
phi_60949_ = _e22178;
} else {
phi_60949_ = select(_e22184, _e22181, (_e22079 == 3u));
}
let _e22191 = phi_60949_;
phi_60950_ = _e22191;
}
let _e22193 = phi_60950_;
phi_60951_ = _e22193;
}
let _e22195 = phi_60951_;
local_32 = (((bitcast<i32>(_e22195) + _e22169.member_1) * _e22175) + _e22169.member);
let _e22200 = local_32;
let _e22202 = (bitcast<i32>(_e262) - 1i);
let _e22204 = select(_e22202, _e22200, (_e22200 < _e22202));
let _e22209 = global_6.member[bitcast<u32>(select(0i, _e22204, (_e22204 > 0i)))];
let _e22214 = (((((select(_e22159, _e22163, _e453) + 0.5f) / _e21704) * 2f) - 1f) * _e21712);
let _e22219 = ((1f - (((select(_e22163, _e22159, _e453) + 0.5f) / _e21705) * 2f)) * _e21720);
let _e22226 = ((_e21723.member * _e22214) + (_e21731.member * _e22219));
let _e22227 = ((_e21723.member_1 * _e22214) + (_e21731.member_1 * _e22219));
let _e22228 = ((_e21723.member_2 * _e22214) + (_e21731.member_2 * _e22219));
let _e22232 = select((_e21746.member + _e22226), _e21746.member, _e21744);
let _e22233 = select((_e21746.member_1 + _e22227), _e21746.member_1, _e21744);
let _e22234 = select((_e21746.member_2 + _e22228), _e21746.member_2, _e21744);
let _e22245 = (((_e22232 * _e22232) + (_e22233 * _e22233)) + (_e22234 * _e22234));
let _e22249 = (1f / sqrt(select(0f, _e22245, (_e22245 > 0f))));
let _e22250 = (_e22232 * _e22249);
let _e22251 = (_e22233 * _e22249);
let _e22252 = (_e22234 * _e22249);
let _e22253 = (_e575 - select(_e21757.member, (_e21757.member + _e22226), _e21744));
let _e22254 = (_e587 - select(_e21757.member_1, (_e21757.member_1 + _e22227), _e21744));
let _e22255 = (_e600 - select(_e21757.member_2, (_e21757.member_2 + _e22228), _e21744));
let _e22260 = (((_e22253 * _e22250) + (_e22254 * _e22251)) + (_e22255 * _e22252));
let _e22265 = (((_e22253 * _e613) + (_e22254 * _e626)) + (_e22255 * _e639));
let _e22270 = (((_e22250 * _e613) + (_e22251 * _e626)) + (_e22252 * _e639));
let _e22273 = ((_e22251 * _e639) - (_e22252 * _e626));
let _e22276 = ((_e22252 * _e613) - (_e22250 * _e639));
let _e22279 = ((_e22250 * _e626) - (_e22251 * _e613));
let _e22284 = (((_e22273 * _e22273) + (_e22276 * _e22276)) + (_e22279 * _e22279));
let _e22287 = (1f / select(1e-9f, _e22284, (_e22284 > 1e-9f)));
let _e22290 = ((_e22260 - (_e22270 * _e22265)) * _e22287);
let _e22293 = (((_e22270 * _e22260) - _e22265) * _e22287);
let _e22299 = select(0f, _e22290, (((_e22293 >= 0f) && (_e22293 < _e691)) && (_e22290 > 0f)));
let _e22301 = (_e22149 << bitcast<u32>(_e22080));
let _e22313 = (_e22121 + 1i);
let _e22316 = select(_e22313, 0i, (_e22313 < 0i));
let _e22317 = (_e22316 >= _e22096.member);
if _e22317 {
phi_61612_ = (_e22096.member - 1i);
} else {
phi_61612_ = _e22316;
}
let _e22320 = phi_61612_;
if _e22152 {
phi_61623_ = (_e22096.member_1 - 1i);
} else {
phi_61623_ = _e22151;
}
let _e22323 = phi_61623_;
let _e22327 = (((f32(_e22320) + 0.5f) * _e22101) - 0.5f);
let _e22331 = (((f32(_e22323) + 0.5f) * _e22101) - 0.5f);
if _e453 {
phi_61651_ = type_23(_e22323, _e22320);
} else {
phi_61651_ = type_23(_e22320, _e22323);
}
let _e22337 = phi_61651_;
if _e22185 {
phi_61702_ = 0u;
} else {
if (_e22079 == 1u) {
phi_61701_ = 0u;
} else {
if (_e22079 == 2u) {
phi_61700_ = _e22178;
} else {
phi_61700_ = select(_e22184, _e22181, (_e22079 == 3u));
}
let _e22345 = phi_61700_;
phi_61701_ = _e22345;
}
let _e22347 = phi_61701_;
phi_61702_ = _e22347;
}
let _e22349 = phi_61702_;
local_30 = (((bitcast<i32>(_e22349) + _e22337.member_1) * _e22175) + _e22337.member);
let _e22354 = local_30;
let _e22356 = select(_e22202, _e22354, (_e22354 < _e22202));
let _e22361 = global_6.member[bitcast<u32>(select(0i, _e22356, (_e22356 > 0i)))];
let _e22366 = (((((select(_e22327, _e22331, _e453) + 0.5f) / _e21704) * 2f) - 1f) * _e21712);
let _e22371 = ((1f - (((select(_e22331, _e22327, _e453) + 0.5f) / _e21705) * 2f)) * _e21720);
let _e22378 = ((_e21723.member * _e22366) + (_e21731.member * _e22371));
let _e22379 = ((_e21723.member_1 * _e22366) + (_e21731.member_1 * _e22371));
let _e22380 = ((_e21723.member_2 * _e22366) + (_e21731.member_2 * _e22371));
let _e22384 = select((_e21746.member + _e22378), _e21746.member, _e21744);
let _e22385 = select((_e21746.member_1 + _e22379), _e21746.member_1, _e21744);
let _e22386 = select((_e21746.member_2 + _e22380), _e21746.member_2, _e21744);
let _e22397 = (((_e22384 * _e22384) + (_e22385 * _e22385)) + (_e22386 * _e22386));
let _e22401 = (1f / sqrt(select(0f, _e22397, (_e22397 > 0f))));
let _e22402 = (_e22384 * _e22401);
let _e22403 = (_e22385 * _e22401);
let _e22404 = (_e22386 * _e22401);
let _e22405 = (_e575 - select(_e21757.member, (_e21757.member + _e22378), _e21744));
let _e22406 = (_e587 - select(_e21757.member_1, (_e21757.member_1 + _e22379), _e21744));
let _e22407 = (_e600 - select(_e21757.member_2, (_e21757.member_2 + _e22380), _e21744));
let _e22412 = (((_e22405 * _e22402) + (_e22406 * _e22403)) + (_e22407 * _e22404));
let _e22417 = (((_e22405 * _e613) + (_e22406 * _e626)) + (_e22407 * _e639));
let _e22422 = (((_e22402 * _e613) + (_e22403 * _e626)) + (_e22404 * _e639));
let _e22425 = ((_e22403 * _e639) - (_e22404 * _e626));
let _e22428 = ((_e22404 * _e613) - (_e22402 * _e639));
let _e22431 = ((_e22402 * _e626) - (_e22403 * _e613));
let _e22436 = (((_e22425 * _e22425) + (_e22428 * _e22428)) + (_e22431 * _e22431));
let _e22439 = (1f / select(1e-9f, _e22436, (_e22436 > 1e-9f)));
let _e22442 = ((_e22412 - (_e22422 * _e22417)) * _e22439);
let _e22445 = (((_e22422 * _e22412) - _e22417) * _e22439);
let _e22451 = select(0f, _e22442, (((_e22445 >= 0f) && (_e22445 < _e691)) && (_e22442 > 0f)));
let _e22453 = (_e22320 << bitcast<u32>(_e22080));
let _e22465 = (_e22136 + 1i);
if _e22146 {
phi_62363_ = (_e22096.member - 1i);
} else {
phi_62363_ = _e22145;
}
let _e22469 = phi_62363_;
let _e22471 = select(_e22465, 0i, (_e22465 < 0i));
let _e22472 = (_e22471 >= _e22096.member_1);
if _e22472 {
phi_62374_ = (_e22096.member_1 - 1i);
} else {
phi_62374_ = _e22471;
}
let _e22475 = phi_62374_;
let _e22479 = (((f32(_e22469) + 0.5f) * _e22101) - 0.5f);
let _e22483 = (((f32(_e22475) + 0.5f) * _e22101) - 0.5f);
if _e453 {
phi_62402_ = type_23(_e22475, _e22469);
} else {
phi_62402_ = type_23(_e22469, _e22475);
}
let _e22489 = phi_62402_;
if _e22185 {
phi_62453_ = 0u;
} else {
if (_e22079 == 1u) {
phi_62452_ = 0u;
} else {
if (_e22079 == 2u) {
phi_62451_ = _e22178;
} else {
phi_62451_ = select(_e22184, _e22181, (_e22079 == 3u));
}
let _e22497 = phi_62451_;
phi_62452_ = _e22497;
}
let _e22499 = phi_62452_;
phi_62453_ = _e22499;
}
let _e22501 = phi_62453_;
local_28 = (((bitcast<i32>(_e22501) + _e22489.member_1) * _e22175) + _e22489.member);
let _e22506 = local_28;
let _e22508 = select(_e22202, _e22506, (_e22506 < _e22202));
let _e22513 = global_6.member[bitcast<u32>(select(0i, _e22508, (_e22508 > 0i)))];
let _e22518 = (((((select(_e22479, _e22483, _e453) + 0.5f) / _e21704) * 2f) - 1f) * _e21712);
let _e22523 = ((1f - (((select(_e22483, _e22479, _e453) + 0.5f) / _e21705) * 2f)) * _e21720);
let _e22530 = ((_e21723.member * _e22518) + (_e21731.member * _e22523));
let _e22531 = ((_e21723.member_1 * _e22518) + (_e21731.member_1 * _e22523));
let _e22532 = ((_e21723.member_2 * _e22518) + (_e21731.member_2 * _e22523));
let _e22536 = select((_e21746.member + _e22530), _e21746.member, _e21744);
let _e22537 = select((_e21746.member_1 + _e22531), _e21746.member_1, _e21744);
let _e22538 = select((_e21746.member_2 + _e22532), _e21746.member_2, _e21744);
let _e22549 = (((_e22536 * _e22536) + (_e22537 * _e22537)) + (_e22538 * _e22538));
let _e22553 = (1f / sqrt(select(0f, _e22549, (_e22549 > 0f))));
let _e22554 = (_e22536 * _e22553);
let _e22555 = (_e22537 * _e22553);
let _e22556 = (_e22538 * _e22553);
let _e22557 = (_e575 - select(_e21757.member, (_e21757.member + _e22530), _e21744));
let _e22558 = (_e587 - select(_e21757.member_1, (_e21757.member_1 + _e22531), _e21744));
let _e22559 = (_e600 - select(_e21757.member_2, (_e21757.member_2 + _e22532), _e21744));
let _e22564 = (((_e22557 * _e22554) + (_e22558 * _e22555)) + (_e22559 * _e22556));
let _e22569 = (((_e22557 * _e613) + (_e22558 * _e626)) + (_e22559 * _e639));
let _e22574 = (((_e22554 * _e613) + (_e22555 * _e626)) + (_e22556 * _e639));
let _e22577 = ((_e22555 * _e639) - (_e22556 * _e626));
let _e22580 = ((_e22556 * _e613) - (_e22554 * _e639));
let _e22583 = ((_e22554 * _e626) - (_e22555 * _e613));
let _e22588 = (((_e22577 * _e22577) + (_e22580 * _e22580)) + (_e22583 * _e22583));
let _e22591 = (1f / select(1e-9f, _e22588, (_e22588 > 1e-9f)));
let _e22594 = ((_e22564 - (_e22574 * _e22569)) * _e22591);
let _e22597 = (((_e22574 * _e22564) - _e22569) * _e22591);
let _e22603 = select(0f, _e22594, (((_e22597 >= 0f) && (_e22597 < _e691)) && (_e22594 > 0f)));
let _e22605 = (_e22469 << bitcast<u32>(_e22080));
if _e22317 {
phi_63114_ = (_e22096.member - 1i);
} else {
phi_63114_ = _e22316;
}
let _e22620 = phi_63114_;
if _e22472 {
phi_63125_ = (_e22096.member_1 - 1i);
} else {
phi_63125_ = _e22471;
}
let _e22623 = phi_63125_;
let _e22627 = (((f32(_e22620) + 0.5f) * _e22101) - 0.5f);
let _e22631 = (((f32(_e22623) + 0.5f) * _e22101) - 0.5f);
if _e453 {
phi_63153_ = type_23(_e22623, _e22620);
} else {
phi_63153_ = type_23(_e22620, _e22623);
}
let _e22637 = phi_63153_;
if _e22185 {
phi_63204_ = 0u;
} else {
if (_e22079 == 1u) {
phi_63203_ = 0u;
} else {
if (_e22079 == 2u) {
phi_63202_ = _e22178;
} else {
phi_63202_ = select(_e22184, _e22181, (_e22079 == 3u));
}
let _e22645 = phi_63202_;
phi_63203_ = _e22645;
}
let _e22647 = phi_63203_;
phi_63204_ = _e22647;
}
let _e22649 = phi_63204_;
local_26 = (((bitcast<i32>(_e22649) + _e22637.member_1) * _e22175) + _e22637.member);
let _e22654 = local_26;
let _e22656 = select(_e22202, _e22654, (_e22654 < _e22202));
let _e22661 = global_6.member[bitcast<u32>(select(0i, _e22656, (_e22656 > 0i)))];
let _e22666 = (((((select(_e22627, _e22631, _e453) + 0.5f) / _e21704) * 2f) - 1f) * _e21712);
let _e22671 = ((1f - (((select(_e22631, _e22627, _e453) + 0.5f) / _e21705) * 2f)) * _e21720);
let _e22678 = ((_e21723.member * _e22666) + (_e21731.member * _e22671));
let _e22679 = ((_e21723.member_1 * _e22666) + (_e21731.member_1 * _e22671));
let _e22680 = ((_e21723.member_2 * _e22666) + (_e21731.member_2 * _e22671));
let _e22684 = select((_e21746.member + _e22678), _e21746.member, _e21744);
let _e22685 = select((_e21746.member_1 + _e22679), _e21746.member_1, _e21744);
let _e22686 = select((_e21746.member_2 + _e22680), _e21746.member_2, _e21744);
let _e22697 = (((_e22684 * _e22684) + (_e22685 * _e22685)) + (_e22686 * _e22686));
let _e22701 = (1f / sqrt(select(0f, _e22697, (_e22697 > 0f))));
let _e22702 = (_e22684 * _e22701);
let _e22703 = (_e22685 * _e22701);
let _e22704 = (_e22686 * _e22701);
let _e22705 = (_e575 - select(_e21757.member, (_e21757.member + _e22678), _e21744));
let _e22706 = (_e587 - select(_e21757.member_1, (_e21757.member_1 + _e22679), _e21744));
let _e22707 = (_e600 - select(_e21757.member_2, (_e21757.member_2 + _e22680), _e21744));
let _e22712 = (((_e22705 * _e22702) + (_e22706 * _e22703)) + (_e22707 * _e22704));
let _e22717 = (((_e22705 * _e613) + (_e22706 * _e626)) + (_e22707 * _e639));
let _e22722 = (((_e22702 * _e613) + (_e22703 * _e626)) + (_e22704 * _e639));
let _e22725 = ((_e22703 * _e639) - (_e22704 * _e626));
let _e22728 = ((_e22704 * _e613) - (_e22702 * _e639));
let _e22731 = ((_e22702 * _e626) - (_e22703 * _e613));
let _e22736 = (((_e22725 * _e22725) + (_e22728 * _e22728)) + (_e22731 * _e22731));
let _e22739 = (1f / select(1e-9f, _e22736, (_e22736 > 1e-9f)));
let _e22742 = ((_e22712 - (_e22722 * _e22717)) * _e22739);
let _e22745 = (((_e22722 * _e22712) - _e22717) * _e22739);
let _e22751 = select(0f, _e22742, (((_e22745 >= 0f) && (_e22745 < _e691)) && (_e22742 > 0f)));
let _e22753 = (_e22620 << bitcast<u32>(_e22080));
let _e22765 = select(((((1f - select(0f, (_e22141 * _e22142), (((select(select(_e766, _e927, (_e22301 >= _e692)), _e847, (_e22301 < _e298)) == _e22079) && (_e22299 > 0f)) && (_e22299 < _e22209)))) - select(0f, (_e22138 * _e22142), (((select(select(_e766, _e927, (_e22453 >= _e692)), _e847, (_e22453 < _e298)) == _e22079) && (_e22451 > 0f)) && (_e22451 < _e22361)))) - select(0f, (_e22141 * _e22140), (((select(select(_e766, _e927, (_e22605 >= _e692)), _e847, (_e22605 < _e298)) == _e22079) && (_e22603 > 0f)) && (_e22603 < _e22513)))) - select(0f, (_e22138 * _e22140), (((select(select(_e766, _e927, (_e22753 >= _e692)), _e847, (_e22753 < _e298)) == _e22079) && (_e22751 > 0f)) && (_e22751 < _e22661)))), 1f, _e22185);
if _e453 {
phi_63874_ = type_23(_e21621, _e21528);
} else {
phi_63874_ = type_23(_e21528, _e21621);
}
let _e22780 = phi_63874_;
let _e22783 = (_e21622 && (((_e22077 > 0f) && (_e22077 < _e21701)) && (bitcast<f32>((bitcast<u32>(_e22765) & 2147483647u)) > 1e-6f)));
let _e22786 = global_1.member.member_18.member;
let _e22787 = (((select(_e21647, (1f - _e21647), (_e21632 >= 0f)) - select(_e21666, (1f - _e21666), (_e21651 >= 0f))) * (1f / _e21629)) * _e22786);
let _e22791 = select(0f, (((((_e652 * _e21914.member) * ((1f + (_e21954 * (1f + (_e21954 * (0.5f + (_e21954 * (0.16666667f + (_e21954 * (0.041666668f + (_e21954 * (0.008333334f + (_e21954 * (0.001388889f + (_e21954 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21949 + 127i)) << bitcast<u32>(23i))))) * _e21907) * _e22765) * _e22787), _e22783);
let _e22792 = select(0f, (((((_e665 * _e21914.member_1) * ((1f + (_e22002 * (1f + (_e22002 * (0.5f + (_e22002 * (0.16666667f + (_e22002 * (0.041666668f + (_e22002 * (0.008333334f + (_e22002 * (0.001388889f + (_e22002 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21997 + 127i)) << bitcast<u32>(23i))))) * _e21907) * _e22765) * _e22787), _e22783);
let _e22793 = select(0f, (((((_e678 * _e21914.member_2) * ((1f + (_e22050 * (1f + (_e22050 * (0.5f + (_e22050 * (0.16666667f + (_e22050 * (0.041666668f + (_e22050 * (0.008333334f + (_e22050 * (0.001388889f + (_e22050 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e22045 + 127i)) << bitcast<u32>(23i))))) * _e21907) * _e22765) * _e22787), _e22783);
let _e22797 = (bitcast<f32>((bitcast<u32>(_e22791) & 2147483647u)) >= 1073741800f);
let _e22798 = (1f / 1048576f);
let _e22801 = ((_e22791 * select(1f, _e22798, _e22797)) + 0.5f);
let _e22803 = select(-1073741800f, _e22801, (_e22801 > -1073741800f));
let _e22805 = select(1073741800f, _e22803, (_e22803 < 1073741800f));
let _e22812 = select(0i, select(select(i32(_e22805), i32(-2147483648), (_e22805 < -2147483600f)), 2147483647i, (_e22805 > 2147483500f)), (_e22805 == _e22805));
let _e22816 = (_e22812 - select(0i, 1i, (_e22805 < f32(_e22812))));
let _e22817 = select(0i, 20i, _e22797);
let _e22821 = (bitcast<u32>(_e22816) << bitcast<u32>((_e22817 & 31i)));
let _e22828 = bitcast<u32>(((_e22816 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22817) & 31i))));
let _e22832 = (bitcast<f32>((bitcast<u32>(_e22792) & 2147483647u)) >= 1073741800f);
let _e22835 = ((_e22792 * select(1f, _e22798, _e22832)) + 0.5f);
let _e22837 = select(-1073741800f, _e22835, (_e22835 > -1073741800f));
let _e22839 = select(1073741800f, _e22837, (_e22837 < 1073741800f));
let _e22846 = select(0i, select(select(i32(_e22839), i32(-2147483648), (_e22839 < -2147483600f)), 2147483647i, (_e22839 > 2147483500f)), (_e22839 == _e22839));
let _e22850 = (_e22846 - select(0i, 1i, (_e22839 < f32(_e22846))));
let _e22851 = select(0i, 20i, _e22832);
let _e22855 = (bitcast<u32>(_e22850) << bitcast<u32>((_e22851 & 31i)));
let _e22862 = bitcast<u32>(((_e22850 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22851) & 31i))));
let _e22866 = (bitcast<f32>((bitcast<u32>(_e22793) & 2147483647u)) >= 1073741800f);
let _e22869 = ((_e22793 * select(1f, _e22798, _e22866)) + 0.5f);
let _e22871 = select(-1073741800f, _e22869, (_e22869 > -1073741800f));
let _e22873 = select(1073741800f, _e22871, (_e22871 < 1073741800f));
let _e22880 = select(0i, select(select(i32(_e22873), i32(-2147483648), (_e22873 < -2147483600f)), 2147483647i, (_e22873 > 2147483500f)), (_e22873 == _e22873));
let _e22884 = (_e22880 - select(0i, 1i, (_e22873 < f32(_e22880))));
let _e22885 = select(0i, 20i, _e22866);
let _e22889 = (bitcast<u32>(_e22884) << bitcast<u32>((_e22885 & 31i)));
let _e22896 = bitcast<u32>(((_e22884 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22885) & 31i))));
let _e22901 = bitcast<i32>(bitcast<u32>((((_e22780.member_1 * _e14765) + _e22780.member) * 6i)));
if ((_e22821 | _e22828) == 0u) {
} else {
let _e22904 = bitcast<u32>(_e22901);
if (_e22904 < _e270) {
let _e22908 = atomicAdd((&global_8.member[_e22904]), _e22821);
phi_64107_ = _e22908;
} else {
phi_64107_ = 0u;
}
let _e22910 = phi_64107_;
let _e22914 = (_e22828 + select(0u, 1u, ((_e22910 + _e22821) < _e22821)));
if (_e22914 == 0u) {
} else {
let _e22916 = (_e22904 + 1u);
if (_e22916 < _e270) {
let _e22920 = atomicAdd((&global_8.member[_e22916]), _e22914);
}
}
}
if ((_e22855 | _e22862) == 0u) {
} else {
let _e22924 = bitcast<u32>((_e22901 + 2i));
if (_e22924 < _e270) {
let _e22928 = atomicAdd((&global_8.member[_e22924]), _e22855);
phi_64137_ = _e22928;
} else {
phi_64137_ = 0u;
}
let _e22930 = phi_64137_;
let _e22934 = (_e22862 + select(0u, 1u, ((_e22930 + _e22855) < _e22855)));
if (_e22934 == 0u) {
} else {
let _e22936 = (_e22924 + 1u);
if (_e22936 < _e270) {
let _e22940 = atomicAdd((&global_8.member[_e22936]), _e22934);
}
}
}
if ((_e22889 | _e22896) == 0u) {
} else {
let _e22944 = bitcast<u32>((_e22901 + 4i));
if (_e22944 < _e270) {
let _e22948 = atomicAdd((&global_8.member[_e22944]), _e22889);
phi_64167_ = _e22948;
} else {
phi_64167_ = 0u;
}
let _e22950 = phi_64167_;
let _e22954 = (_e22896 + select(0u, 1u, ((_e22950 + _e22889) < _e22889)));
if (_e22954 == 0u) {
} else {
let _e22956 = (_e22944 + 1u);
if (_e22956 < _e270) {
let _e22960 = atomicAdd((&global_8.member[_e22956]), _e22954);
}
}
}
phi_59981_ = (_e21619 + 1i);
} else {
phi_59981_ = i32();
}
let _e22963 = phi_59981_;
continue;
continuing {
phi_59980_ = _e22963;
break if !(_e21622);
}
}
phi_59827_ = (_e21525 + 1i);
} else {
phi_59827_ = i32();
}
let _e22967 = phi_59827_;
continue;
continuing {
phi_59826_ = _e22967;
break if !(_e21526);
}
}
} else {
phi_64212_ = 0i;
loop {
let _e22970 = phi_64212_;
let _e22971 = (_e22970 < 16i);
if _e22971 {
let _e22973 = (_e14810 + (_e22970 & 15i));
let _e22975 = (f32(_e22973) + 0.5f);
let _e22977 = ((_e22975 * 1f) - 0.5f);
let _e22981 = (-(((_e416 * _e22977) + _e442)) / _e429);
let _e22988 = bitcast<f32>((bitcast<u32>(((_e466 * _e22977) + ((_e479 * _e22981) + _e492))) & 2147483647u));
let _e22995 = bitcast<f32>((bitcast<u32>(((_e505 * _e22977) + ((_e518 * _e22981) + _e531))) & 2147483647u));
let _e22999 = (((0.5f * (_e22988 + _e22995)) / _e534) + _e717);
let _e23000 = (1f / 1f);
let _e23008 = ((((_e22981 + _e22999) + 0.5f) * _e23000) - 0.5f);
let _e23009 = f32(_e20754);
let _e23010 = f32(_e20752);
let _e23011 = (_e23009 - 1f);
let _e23013 = select(_e23011, _e23008, (_e23008 > _e23011));
let _e23015 = select(_e23010, _e23013, (_e23013 < _e23010));
let _e23022 = select(0i, select(select(i32(_e23015), i32(-2147483648), (_e23015 < -2147483600f)), 2147483647i, (_e23015 > 2147483500f)), (_e23015 == _e23015));
let _e23027 = (((((_e22981 - _e22999) + 0.5f) * _e23000) - 0.5f) + 1f);
let _e23028 = (_e23010 + 1f);
let _e23030 = select(_e23009, _e23027, (_e23027 > _e23009));
let _e23032 = select(_e23028, _e23030, (_e23030 < _e23028));
let _e23039 = select(0i, select(select(i32(_e23032), i32(-2147483648), (_e23032 < -2147483600f)), 2147483647i, (_e23032 > 2147483500f)), (_e23032 == _e23032));
let _e23050 = ((1e-4f * 1f) * _e534);
let _e23052 = select(_e22995, _e22988, (_e22988 > _e22995));
let _e23054 = select(_e23050, _e23052, (_e23052 > _e23050));
let _e23056 = select(_e22995, _e22988, (_e22988 < _e22995));
let _e23058 = select(_e23050, _e23056, (_e23056 > _e23050));
let _e23060 = (0.5f * (_e23054 + _e23058));
let _e23061 = (0.5f / _e23058);
let _e23062 = (1f / _e23054);
phi_64366_ = 0i;
loop {
let _e23064 = phi_64366_;
let _e23066 = (((_e23039 - select(0i, 1i, (_e23032 < f32(_e23039)))) + (_e22970 >> bitcast<u32>(4u))) + bitcast<i32>(_e23064));
let _e23067 = (_e23066 <= select(-1i, (_e23022 - select(0i, 1i, (_e23015 < f32(_e23022)))), (_e22973 <= _e14814)));
if _e23067 {
let _e23069 = (f32(_e23066) + 0.5f);
let _e23073 = ((((_e23069 * 1f) - 0.5f) - _e22981) * _e534);
let _e23074 = (_e534 * 1f);
let _e23076 = (0.5f * _e23074);
let _e23077 = (_e23073 + _e23076);
let _e23078 = -(_e23077);
let _e23081 = (_e23060 - select(_e23078, _e23077, (_e23077 > _e23078)));
let _e23083 = select(0f, _e23081, (_e23081 > 0f));
let _e23085 = select(_e23058, _e23083, (_e23083 < _e23058));
let _e23088 = (_e23081 - _e23058);
let _e23092 = (((_e23085 * (_e23085 * _e23061)) + select(0f, _e23088, (_e23088 > 0f))) * _e23062);
let _e23096 = (_e23073 - _e23076);
let _e23097 = -(_e23096);
let _e23100 = (_e23060 - select(_e23097, _e23096, (_e23096 > _e23097)));
let _e23102 = select(0f, _e23100, (_e23100 > 0f));
let _e23104 = select(_e23058, _e23102, (_e23102 < _e23058));
let _e23107 = (_e23100 - _e23058);
let _e23111 = (((_e23104 * (_e23104 * _e23061)) + select(0f, _e23107, (_e23107 > 0f))) * _e23062);
if _e453 {
phi_64471_ = type_23(_e23066, _e22973);
} else {
phi_64471_ = type_23(_e22973, _e23066);
}
let _e23120 = phi_64471_;
local_24 = bitcast<i32>((_e14761 * _e14764));
local_25 = ((_e23120.member_1 * _e14765) + _e23120.member);
let _e23127 = local_24;
let _e23128 = local_25;
let _e23129 = (_e23127 + _e23128);
let _e23131 = (bitcast<i32>(_e259) - 1i);
let _e23133 = select(_e23131, _e23129, (_e23129 < _e23131));
let _e23138 = global_5.member[bitcast<u32>(select(0i, _e23133, (_e23133 > 0i)))];
let _e23139 = local_25;
let _e23141 = select(_e23131, _e23139, (_e23139 < _e23131));
let _e23146 = global_5.member[bitcast<u32>(select(0i, _e23141, (_e23141 > 0i)))];
let _e23149 = f32(_e14765);
let _e23150 = f32(_e14766);
let _e23157 = global_1.member.member_2.member;
let _e23158 = (((((f32(_e23120.member) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e23165 = global_1.member.member_2.member_1;
let _e23166 = ((1f - (((f32(_e23120.member_1) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e23168 = global_1.member.member_3;
let _e23176 = global_1.member.member_4;
let _e23183 = ((_e23168.member * _e23158) + (_e23176.member * _e23166));
let _e23184 = ((_e23168.member_1 * _e23158) + (_e23176.member_1 * _e23166));
let _e23185 = ((_e23168.member_2 * _e23158) + (_e23176.member_2 * _e23166));
let _e23188 = global_1.member.member_2.member_3;
let _e23189 = (_e23188 != 0u);
let _e23191 = global_1.member.member_5;
let _e23198 = select((_e23191.member + _e23183), _e23191.member, _e23189);
let _e23199 = select((_e23191.member_1 + _e23184), _e23191.member_1, _e23189);
let _e23200 = select((_e23191.member_2 + _e23185), _e23191.member_2, _e23189);
let _e23202 = global_1.member.member_6;
let _e23216 = (((_e23198 * _e23198) + (_e23199 * _e23199)) + (_e23200 * _e23200));
let _e23219 = sqrt(select(0f, _e23216, (_e23216 > 0f)));
let _e23220 = (1f / _e23219);
let _e23221 = (_e23198 * _e23220);
let _e23222 = (_e23199 * _e23220);
let _e23223 = (_e23200 * _e23220);
let _e23224 = (_e575 - select(_e23202.member, (_e23202.member + _e23183), _e23189));
let _e23225 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e23184), _e23189));
let _e23226 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e23185), _e23189));
let _e23231 = (((_e23224 * _e23221) + (_e23225 * _e23222)) + (_e23226 * _e23223));
let _e23236 = (((_e23224 * _e613) + (_e23225 * _e626)) + (_e23226 * _e639));
let _e23241 = (((_e23221 * _e613) + (_e23222 * _e626)) + (_e23223 * _e639));
let _e23244 = ((_e23222 * _e639) - (_e23223 * _e626));
let _e23247 = ((_e23223 * _e613) - (_e23221 * _e639));
let _e23250 = ((_e23221 * _e626) - (_e23222 * _e613));
let _e23255 = (((_e23244 * _e23244) + (_e23247 * _e23247)) + (_e23250 * _e23250));
let _e23258 = (1f / select(1e-9f, _e23255, (_e23255 > 1e-9f)));
let _e23261 = ((_e23231 - (_e23241 * _e23236)) * _e23258);
let _e23264 = (((_e23241 * _e23231) - _e23236) * _e23258);
let _e23270 = -(_e23241);
let _e23273 = global_1.member.member_13.member_2;
let _e23274 = (_e23273 * _e23273);
let _e23278 = ((1f + _e23274) - ((2f * _e23273) * _e23270));
let _e23280 = select(1e-9f, _e23278, (_e23278 > 1e-9f));
let _e23292 = global_1.member.member_13.member_3;
if (_e23292 == 2u) {
let _e23297 = (0.5f - (0.5f * _e23270));
let _e23299 = select(0f, _e23297, (_e23297 > 0f));
let _e23303 = (sqrt(select(0f, _e23299, (_e23299 > 0f))) * 255f);
let _e23304 = (255f - 1f);
let _e23306 = select(0f, _e23303, (_e23303 > 0f));
let _e23308 = select(_e23304, _e23306, (_e23306 < _e23304));
let _e23315 = select(0i, select(select(i32(_e23308), i32(-2147483648), (_e23308 < -2147483600f)), 2147483647i, (_e23308 > 2147483500f)), (_e23308 == _e23308));
let _e23319 = (_e23315 - select(0i, 1i, (_e23308 < f32(_e23315))));
let _e23322 = global_1.member.member_13.member_11;
let _e23323 = bitcast<i32>(_e23322);
let _e23324 = (_e23323 + _e23319);
let _e23326 = (bitcast<i32>(_e265) - 1i);
let _e23328 = select(_e23326, _e23324, (_e23324 < _e23326));
let _e23333 = global_2.member[bitcast<u32>(select(0i, _e23328, (_e23328 > 0i)))];
let _e23335 = (_e23323 + (_e23319 + 1i));
let _e23337 = select(_e23326, _e23335, (_e23335 < _e23326));
let _e23342 = global_2.member[bitcast<u32>(select(0i, _e23337, (_e23337 > 0i)))];
phi_64898_ = (_e23333 + ((_e23342 - _e23333) * (_e23303 - f32(_e23319))));
} else {
phi_64898_ = select(((1f - _e23274) / (_e23280 * sqrt(select(0f, _e23280, (_e23280 > 0f))))), (0.75f * (1f + (_e23270 * _e23270))), (_e23292 == 1u));
}
let _e23349 = phi_64898_;
let _e23352 = (_e23219 * (_e23349 * (0.25f / 3.1415927f)));
let _e23353 = (_e23261 - _e23138);
let _e23356 = (_e23264 + select(0f, _e23353, (_e23353 > 0f)));
let _e23359 = global_1.member.member_13.member_1;
let _e23368 = global_1.member.member_13.member;
let _e23373 = -((_e23368.member * _e23356));
let _e23375 = select(-87f, _e23373, (_e23373 > -87f));
let _e23377 = select(88f, _e23375, (_e23375 < 88f));
let _e23379 = ((_e23377 * 1.442695f) + 0.5f);
let _e23381 = select(-127f, _e23379, (_e23379 > -127f));
let _e23383 = select(128f, _e23381, (_e23381 < 128f));
let _e23390 = select(0i, select(select(i32(_e23383), i32(-2147483648), (_e23383 < -2147483600f)), 2147483647i, (_e23383 > 2147483500f)), (_e23383 == _e23383));
let _e23394 = (_e23390 - select(0i, 1i, (_e23383 < f32(_e23390))));
let _e23395 = f32(_e23394);
let _e23399 = ((_e23377 - (_e23395 * 0.6933594f)) - (_e23395 * -2.1219444e-4f));
let _e23421 = -((_e23368.member_1 * _e23356));
let _e23423 = select(-87f, _e23421, (_e23421 > -87f));
let _e23425 = select(88f, _e23423, (_e23423 < 88f));
let _e23427 = ((_e23425 * 1.442695f) + 0.5f);
let _e23429 = select(-127f, _e23427, (_e23427 > -127f));
let _e23431 = select(128f, _e23429, (_e23429 < 128f));
let _e23438 = select(0i, select(select(i32(_e23431), i32(-2147483648), (_e23431 < -2147483600f)), 2147483647i, (_e23431 > 2147483500f)), (_e23431 == _e23431));
let _e23442 = (_e23438 - select(0i, 1i, (_e23431 < f32(_e23438))));
let _e23443 = f32(_e23442);
let _e23447 = ((_e23425 - (_e23443 * 0.6933594f)) - (_e23443 * -2.1219444e-4f));
let _e23469 = -((_e23368.member_2 * _e23356));
let _e23471 = select(-87f, _e23469, (_e23469 > -87f));
let _e23473 = select(88f, _e23471, (_e23471 < 88f));
let _e23475 = ((_e23473 * 1.442695f) + 0.5f);
let _e23477 = select(-127f, _e23475, (_e23475 > -127f));
let _e23479 = select(128f, _e23477, (_e23477 < 128f));
let _e23486 = select(0i, select(select(i32(_e23479), i32(-2147483648), (_e23479 < -2147483600f)), 2147483647i, (_e23479 > 2147483500f)), (_e23479 == _e23479));
let _e23490 = (_e23486 - select(0i, 1i, (_e23479 < f32(_e23486))));
let _e23491 = f32(_e23490);
let _e23495 = ((_e23473 - (_e23491 * 0.6933594f)) - (_e23491 * -2.1219444e-4f));
let _e23522 = select(0f, _e23261, (((_e23264 >= 0f) && (_e23264 < _e691)) && (_e23261 > 0f)));
if _e453 {
phi_65167_ = type_23(_e19824, _e19823);
} else {
phi_65167_ = type_23(_e19823, _e19824);
}
let _e23526 = phi_65167_;
let _e23531 = f32((1i << bitcast<u32>(_e19812)));
let _e23532 = (1f / _e23531);
let _e23534 = ((_e22975 * _e23532) - 0.5f);
let _e23536 = ((_e23069 * _e23532) - 0.5f);
let _e23538 = select(-1f, _e23534, (_e23534 > -1f));
let _e23540 = select(1e6f, _e23538, (_e23538 < 1e6f));
let _e23547 = select(0i, select(select(i32(_e23540), i32(-2147483648), (_e23540 < -2147483600f)), 2147483647i, (_e23540 > 2147483500f)), (_e23540 == _e23540));
let _e23551 = (_e23547 - select(0i, 1i, (_e23540 < f32(_e23547))));
let _e23553 = select(-1f, _e23536, (_e23536 > -1f));
let _e23555 = select(1e6f, _e23553, (_e23553 < 1e6f));
let _e23562 = select(0i, select(select(i32(_e23555), i32(-2147483648), (_e23555 < -2147483600f)), 2147483647i, (_e23555 > 2147483500f)), (_e23555 == _e23555));
let _e23566 = (_e23562 - select(0i, 1i, (_e23555 < f32(_e23562))));
let _e23568 = (_e23534 - f32(_e23551));
let _e23570 = (_e23536 - f32(_e23566));
let _e23571 = (1f - _e23568);
let _e23572 = (1f - _e23570);
let _e23575 = select(_e23551, 0i, (_e23551 < 0i));
let _e23576 = (_e23575 >= _e23526.member);
if _e23576 {
phi_65245_ = (_e23526.member - 1i);
} else {
phi_65245_ = _e23575;
}
let _e23579 = phi_65245_;
let _e23581 = select(_e23566, 0i, (_e23566 < 0i));
let _e23582 = (_e23581 >= _e23526.member_1);
if _e23582 {
phi_65256_ = (_e23526.member_1 - 1i);
} else {
phi_65256_ = _e23581;
}
let _e23585 = phi_65256_;
let _e23589 = (((f32(_e23579) + 0.5f) * _e23531) - 0.5f);
let _e23593 = (((f32(_e23585) + 0.5f) * _e23531) - 0.5f);
if _e453 {
phi_65284_ = type_23(_e23585, _e23579);
} else {
phi_65284_ = type_23(_e23579, _e23585);
}
let _e23599 = phi_65284_;
let _e23605 = bitcast<i32>(((_e14761 + 1u) >> bitcast<u32>(1u)));
let _e23608 = global_1.member.member_18.member_6;
let _e23611 = global_1.member.member_18.member_7;
let _e23614 = global_1.member.member_18.member_8;
if _e14816 {
phi_65335_ = 0u;
} else {
if (_e766 == 1u) {
phi_65334_ = 0u;
} else {
if (_e766 == 2u) {
phi_65333_ = _e23608;
} else {
phi_65333_ = select(_e23614, _e23611, (_e766 == 3u));
}
let _e23620 = phi_65333_;
phi_65334_ = _e23620;
}
let _e23622 = phi_65334_;
phi_65335_ = _e23622;
}
let _e23624 = phi_65335_;
local_22 = (((bitcast<i32>(_e23624) + _e23599.member_1) * _e23605) + _e23599.member);
let _e23629 = local_22;
let _e23631 = (bitcast<i32>(_e262) - 1i);
let _e23633 = select(_e23631, _e23629, (_e23629 < _e23631));
let _e23638 = global_6.member[bitcast<u32>(select(0i, _e23633, (_e23633 > 0i)))];
let _e23643 = (((((select(_e23589, _e23593, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e23648 = ((1f - (((select(_e23593, _e23589, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e23655 = ((_e23168.member * _e23643) + (_e23176.member * _e23648));
let _e23656 = ((_e23168.member_1 * _e23643) + (_e23176.member_1 * _e23648));
let _e23657 = ((_e23168.member_2 * _e23643) + (_e23176.member_2 * _e23648));
let _e23661 = select((_e23191.member + _e23655), _e23191.member, _e23189);
let _e23662 = select((_e23191.member_1 + _e23656), _e23191.member_1, _e23189);
let _e23663 = select((_e23191.member_2 + _e23657), _e23191.member_2, _e23189);
let _e23674 = (((_e23661 * _e23661) + (_e23662 * _e23662)) + (_e23663 * _e23663));
let _e23678 = (1f / sqrt(select(0f, _e23674, (_e23674 > 0f))));
let _e23679 = (_e23661 * _e23678);
let _e23680 = (_e23662 * _e23678);
let _e23681 = (_e23663 * _e23678);
let _e23682 = (_e575 - select(_e23202.member, (_e23202.member + _e23655), _e23189));
let _e23683 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e23656), _e23189));
let _e23684 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e23657), _e23189));
let _e23689 = (((_e23682 * _e23679) + (_e23683 * _e23680)) + (_e23684 * _e23681));
let _e23694 = (((_e23682 * _e613) + (_e23683 * _e626)) + (_e23684 * _e639));
let _e23699 = (((_e23679 * _e613) + (_e23680 * _e626)) + (_e23681 * _e639));
let _e23702 = ((_e23680 * _e639) - (_e23681 * _e626));
let _e23705 = ((_e23681 * _e613) - (_e23679 * _e639));
let _e23708 = ((_e23679 * _e626) - (_e23680 * _e613));
let _e23713 = (((_e23702 * _e23702) + (_e23705 * _e23705)) + (_e23708 * _e23708));
let _e23716 = (1f / select(1e-9f, _e23713, (_e23713 > 1e-9f)));
let _e23719 = ((_e23689 - (_e23699 * _e23694)) * _e23716);
let _e23722 = (((_e23699 * _e23689) - _e23694) * _e23716);
let _e23728 = select(0f, _e23719, (((_e23722 >= 0f) && (_e23722 < _e691)) && (_e23719 > 0f)));
let _e23730 = (_e23579 << bitcast<u32>(_e19812));
let _e23742 = (_e23551 + 1i);
let _e23745 = select(_e23742, 0i, (_e23742 < 0i));
let _e23746 = (_e23745 >= _e23526.member);
if _e23746 {
phi_65996_ = (_e23526.member - 1i);
} else {
phi_65996_ = _e23745;
}
let _e23749 = phi_65996_;
if _e23582 {
phi_66007_ = (_e23526.member_1 - 1i);
} else {
phi_66007_ = _e23581;
}
let _e23752 = phi_66007_;
let _e23756 = (((f32(_e23749) + 0.5f) * _e23531) - 0.5f);
let _e23760 = (((f32(_e23752) + 0.5f) * _e23531) - 0.5f);
if _e453 {
phi_66035_ = type_23(_e23752, _e23749);
} else {
phi_66035_ = type_23(_e23749, _e23752);
}
let _e23766 = phi_66035_;
if _e14816 {
phi_66086_ = 0u;
} else {
if (_e766 == 1u) {
phi_66085_ = 0u;
} else {
if (_e766 == 2u) {
phi_66084_ = _e23608;
} else {
phi_66084_ = select(_e23614, _e23611, (_e766 == 3u));
}
let _e23774 = phi_66084_;
phi_66085_ = _e23774;
}
let _e23776 = phi_66085_;
phi_66086_ = _e23776;
}
let _e23778 = phi_66086_;
local_20 = (((bitcast<i32>(_e23778) + _e23766.member_1) * _e23605) + _e23766.member);
let _e23783 = local_20;
let _e23785 = select(_e23631, _e23783, (_e23783 < _e23631));
let _e23790 = global_6.member[bitcast<u32>(select(0i, _e23785, (_e23785 > 0i)))];
let _e23795 = (((((select(_e23756, _e23760, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e23800 = ((1f - (((select(_e23760, _e23756, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e23807 = ((_e23168.member * _e23795) + (_e23176.member * _e23800));
let _e23808 = ((_e23168.member_1 * _e23795) + (_e23176.member_1 * _e23800));
let _e23809 = ((_e23168.member_2 * _e23795) + (_e23176.member_2 * _e23800));
let _e23813 = select((_e23191.member + _e23807), _e23191.member, _e23189);
let _e23814 = select((_e23191.member_1 + _e23808), _e23191.member_1, _e23189);
let _e23815 = select((_e23191.member_2 + _e23809), _e23191.member_2, _e23189);
let _e23826 = (((_e23813 * _e23813) + (_e23814 * _e23814)) + (_e23815 * _e23815));
let _e23830 = (1f / sqrt(select(0f, _e23826, (_e23826 > 0f))));
let _e23831 = (_e23813 * _e23830);
let _e23832 = (_e23814 * _e23830);
let _e23833 = (_e23815 * _e23830);
let _e23834 = (_e575 - select(_e23202.member, (_e23202.member + _e23807), _e23189));
let _e23835 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e23808), _e23189));
let _e23836 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e23809), _e23189));
let _e23841 = (((_e23834 * _e23831) + (_e23835 * _e23832)) + (_e23836 * _e23833));
let _e23846 = (((_e23834 * _e613) + (_e23835 * _e626)) + (_e23836 * _e639));
let _e23851 = (((_e23831 * _e613) + (_e23832 * _e626)) + (_e23833 * _e639));
let _e23854 = ((_e23832 * _e639) - (_e23833 * _e626));
let _e23857 = ((_e23833 * _e613) - (_e23831 * _e639));
let _e23860 = ((_e23831 * _e626) - (_e23832 * _e613));
let _e23865 = (((_e23854 * _e23854) + (_e23857 * _e23857)) + (_e23860 * _e23860));
let _e23868 = (1f / select(1e-9f, _e23865, (_e23865 > 1e-9f)));
let _e23871 = ((_e23841 - (_e23851 * _e23846)) * _e23868);
let _e23874 = (((_e23851 * _e23841) - _e23846) * _e23868);
let _e23880 = select(0f, _e23871, (((_e23874 >= 0f) && (_e23874 < _e691)) && (_e23871 > 0f)));
let _e23882 = (_e23749 << bitcast<u32>(_e19812));
let _e23894 = (_e23566 + 1i);
if _e23576 {
phi_66747_ = (_e23526.member - 1i);
} else {
phi_66747_ = _e23575;
}
let _e23898 = phi_66747_;
let _e23900 = select(_e23894, 0i, (_e23894 < 0i));
let _e23901 = (_e23900 >= _e23526.member_1);
if _e23901 {
phi_66758_ = (_e23526.member_1 - 1i);
} else {
phi_66758_ = _e23900;
}
let _e23904 = phi_66758_;
let _e23908 = (((f32(_e23898) + 0.5f) * _e23531) - 0.5f);
let _e23912 = (((f32(_e23904) + 0.5f) * _e23531) - 0.5f);
if _e453 {
phi_66786_ = type_23(_e23904, _e23898);
} else {
phi_66786_ = type_23(_e23898, _e23904);
}
let _e23918 = phi_66786_;
if _e14816 {
phi_66837_ = 0u;
} else {
if (_e766 == 1u) {
phi_66836_ = 0u;
} else {
if (_e766 == 2u) {
phi_66835_ = _e23608;
} else {
phi_66835_ = select(_e23614, _e23611, (_e766 == 3u));
}
let _e23926 = phi_66835_;
phi_66836_ = _e23926;
}
let _e23928 = phi_66836_;
phi_66837_ = _e23928;
}
let _e23930 = phi_66837_;
local_18 = (((bitcast<i32>(_e23930) + _e23918.member_1) * _e23605) + _e23918.member);
let _e23935 = local_18;
let _e23937 = select(_e23631, _e23935, (_e23935 < _e23631));
let _e23942 = global_6.member[bitcast<u32>(select(0i, _e23937, (_e23937 > 0i)))];
let _e23947 = (((((select(_e23908, _e23912, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e23952 = ((1f - (((select(_e23912, _e23908, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e23959 = ((_e23168.member * _e23947) + (_e23176.member * _e23952));
let _e23960 = ((_e23168.member_1 * _e23947) + (_e23176.member_1 * _e23952));
let _e23961 = ((_e23168.member_2 * _e23947) + (_e23176.member_2 * _e23952));
let _e23965 = select((_e23191.member + _e23959), _e23191.member, _e23189);
let _e23966 = select((_e23191.member_1 + _e23960), _e23191.member_1, _e23189);
let _e23967 = select((_e23191.member_2 + _e23961), _e23191.member_2, _e23189);
let _e23978 = (((_e23965 * _e23965) + (_e23966 * _e23966)) + (_e23967 * _e23967));
let _e23982 = (1f / sqrt(select(0f, _e23978, (_e23978 > 0f))));
let _e23983 = (_e23965 * _e23982);
let _e23984 = (_e23966 * _e23982);
let _e23985 = (_e23967 * _e23982);
let _e23986 = (_e575 - select(_e23202.member, (_e23202.member + _e23959), _e23189));
let _e23987 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e23960), _e23189));
let _e23988 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e23961), _e23189));
let _e23993 = (((_e23986 * _e23983) + (_e23987 * _e23984)) + (_e23988 * _e23985));
let _e23998 = (((_e23986 * _e613) + (_e23987 * _e626)) + (_e23988 * _e639));
let _e24003 = (((_e23983 * _e613) + (_e23984 * _e626)) + (_e23985 * _e639));
let _e24006 = ((_e23984 * _e639) - (_e23985 * _e626));
let _e24009 = ((_e23985 * _e613) - (_e23983 * _e639));
let _e24012 = ((_e23983 * _e626) - (_e23984 * _e613));
let _e24017 = (((_e24006 * _e24006) + (_e24009 * _e24009)) + (_e24012 * _e24012));
let _e24020 = (1f / select(1e-9f, _e24017, (_e24017 > 1e-9f)));
let _e24023 = ((_e23993 - (_e24003 * _e23998)) * _e24020);
let _e24026 = (((_e24003 * _e23993) - _e23998) * _e24020);
let _e24032 = select(0f, _e24023, (((_e24026 >= 0f) && (_e24026 < _e691)) && (_e24023 > 0f)));
let _e24034 = (_e23898 << bitcast<u32>(_e19812));
if _e23746 {
phi_67498_ = (_e23526.member - 1i);
} else {
phi_67498_ = _e23745;
}
let _e24049 = phi_67498_;
if _e23901 {
phi_67509_ = (_e23526.member_1 - 1i);
} else {
phi_67509_ = _e23900;
}
let _e24052 = phi_67509_;
let _e24056 = (((f32(_e24049) + 0.5f) * _e23531) - 0.5f);
let _e24060 = (((f32(_e24052) + 0.5f) * _e23531) - 0.5f);
if _e453 {
phi_67537_ = type_23(_e24052, _e24049);
} else {
phi_67537_ = type_23(_e24049, _e24052);
}
let _e24066 = phi_67537_;
if _e14816 {
phi_67588_ = 0u;
} else {
if (_e766 == 1u) {
phi_67587_ = 0u;
} else {
if (_e766 == 2u) {
phi_67586_ = _e23608;
} else {
phi_67586_ = select(_e23614, _e23611, (_e766 == 3u));
}
let _e24074 = phi_67586_;
phi_67587_ = _e24074;
}
let _e24076 = phi_67587_;
phi_67588_ = _e24076;
}
let _e24078 = phi_67588_;
local_16 = (((bitcast<i32>(_e24078) + _e24066.member_1) * _e23605) + _e24066.member);
let _e24083 = local_16;
let _e24085 = select(_e23631, _e24083, (_e24083 < _e23631));
let _e24090 = global_6.member[bitcast<u32>(select(0i, _e24085, (_e24085 > 0i)))];
let _e24095 = (((((select(_e24056, _e24060, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e24100 = ((1f - (((select(_e24060, _e24056, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e24107 = ((_e23168.member * _e24095) + (_e23176.member * _e24100));
let _e24108 = ((_e23168.member_1 * _e24095) + (_e23176.member_1 * _e24100));
let _e24109 = ((_e23168.member_2 * _e24095) + (_e23176.member_2 * _e24100));
let _e24113 = select((_e23191.member + _e24107), _e23191.member, _e23189);
let _e24114 = select((_e23191.member_1 + _e24108), _e23191.member_1, _e23189);
let _e24115 = select((_e23191.member_2 + _e24109), _e23191.member_2, _e23189);
let _e24126 = (((_e24113 * _e24113) + (_e24114 * _e24114)) + (_e24115 * _e24115));
let _e24130 = (1f / sqrt(select(0f, _e24126, (_e24126 > 0f))));
let _e24131 = (_e24113 * _e24130);
let _e24132 = (_e24114 * _e24130);
let _e24133 = (_e24115 * _e24130);
let _e24134 = (_e575 - select(_e23202.member, (_e23202.member + _e24107), _e23189));
let _e24135 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e24108), _e23189));
let _e24136 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e24109), _e23189));
let _e24141 = (((_e24134 * _e24131) + (_e24135 * _e24132)) + (_e24136 * _e24133));
let _e24146 = (((_e24134 * _e613) + (_e24135 * _e626)) + (_e24136 * _e639));
let _e24151 = (((_e24131 * _e613) + (_e24132 * _e626)) + (_e24133 * _e639));
let _e24154 = ((_e24132 * _e639) - (_e24133 * _e626));
let _e24157 = ((_e24133 * _e613) - (_e24131 * _e639));
let _e24160 = ((_e24131 * _e626) - (_e24132 * _e613));
let _e24165 = (((_e24154 * _e24154) + (_e24157 * _e24157)) + (_e24160 * _e24160));
let _e24168 = (1f / select(1e-9f, _e24165, (_e24165 > 1e-9f)));
let _e24171 = ((_e24141 - (_e24151 * _e24146)) * _e24168);
let _e24174 = (((_e24151 * _e24141) - _e24146) * _e24168);
let _e24180 = select(0f, _e24171, (((_e24174 >= 0f) && (_e24174 < _e691)) && (_e24171 > 0f)));
let _e24182 = (_e24049 << bitcast<u32>(_e19812));
let _e24194 = select(((((1f - select(0f, (_e23571 * _e23572), (((select(select(_e766, _e927, (_e23730 >= _e692)), _e847, (_e23730 < _e298)) == _e766) && (_e23728 > 0f)) && (_e23728 < _e23638)))) - select(0f, (_e23568 * _e23572), (((select(select(_e766, _e927, (_e23882 >= _e692)), _e847, (_e23882 < _e298)) == _e766) && (_e23880 > 0f)) && (_e23880 < _e23790)))) - select(0f, (_e23571 * _e23570), (((select(select(_e766, _e927, (_e24034 >= _e692)), _e847, (_e24034 < _e298)) == _e766) && (_e24032 > 0f)) && (_e24032 < _e23942)))) - select(0f, (_e23568 * _e23570), (((select(select(_e766, _e927, (_e24182 >= _e692)), _e847, (_e24182 < _e298)) == _e766) && (_e24180 > 0f)) && (_e24180 < _e24090)))), 1f, _e14816);
let _e24195 = (_e20756 & 31u);
let _e24197 = (1u << bitcast<u32>(_e24195));
let _e24206 = bitcast<i32>((((_e14761 + _e24197) - 1u) >> bitcast<u32>(_e24195)));
let _e24207 = bitcast<i32>((((_e14764 + _e24197) - 1u) >> bitcast<u32>(_e24195)));
if _e453 {
phi_68267_ = type_23(_e24207, _e24206);
} else {
phi_68267_ = type_23(_e24206, _e24207);
}
let _e24211 = phi_68267_;
let _e24216 = f32((1i << bitcast<u32>(_e24195)));
let _e24217 = (1f / _e24216);
let _e24219 = ((_e22975 * _e24217) - 0.5f);
let _e24221 = ((_e23069 * _e24217) - 0.5f);
let _e24223 = select(-1f, _e24219, (_e24219 > -1f));
let _e24225 = select(1e6f, _e24223, (_e24223 < 1e6f));
let _e24232 = select(0i, select(select(i32(_e24225), i32(-2147483648), (_e24225 < -2147483600f)), 2147483647i, (_e24225 > 2147483500f)), (_e24225 == _e24225));
let _e24236 = (_e24232 - select(0i, 1i, (_e24225 < f32(_e24232))));
let _e24238 = select(-1f, _e24221, (_e24221 > -1f));
let _e24240 = select(1e6f, _e24238, (_e24238 < 1e6f));
let _e24247 = select(0i, select(select(i32(_e24240), i32(-2147483648), (_e24240 < -2147483600f)), 2147483647i, (_e24240 > 2147483500f)), (_e24240 == _e24240));
let _e24251 = (_e24247 - select(0i, 1i, (_e24240 < f32(_e24247))));
let _e24253 = (_e24219 - f32(_e24236));
let _e24255 = (_e24221 - f32(_e24251));
let _e24256 = (1f - _e24253);
let _e24257 = (1f - _e24255);
let _e24260 = select(_e24236, 0i, (_e24236 < 0i));
let _e24261 = (_e24260 >= _e24211.member);
if _e24261 {
phi_68345_ = (_e24211.member - 1i);
} else {
phi_68345_ = _e24260;
}
let _e24264 = phi_68345_;
let _e24266 = select(_e24251, 0i, (_e24251 < 0i));
let _e24267 = (_e24266 >= _e24211.member_1);
if _e24267 {
phi_68356_ = (_e24211.member_1 - 1i);
} else {
phi_68356_ = _e24266;
}
let _e24270 = phi_68356_;
let _e24274 = (((f32(_e24264) + 0.5f) * _e24216) - 0.5f);
let _e24278 = (((f32(_e24270) + 0.5f) * _e24216) - 0.5f);
if _e453 {
phi_68384_ = type_23(_e24270, _e24264);
} else {
phi_68384_ = type_23(_e24264, _e24270);
}
let _e24284 = phi_68384_;
let _e24287 = (_e20756 == 0u);
if _e24287 {
phi_68435_ = 0u;
} else {
if (_e20756 == 1u) {
phi_68434_ = 0u;
} else {
if (_e20756 == 2u) {
phi_68433_ = _e23608;
} else {
phi_68433_ = select(_e23614, _e23611, (_e20756 == 3u));
}
let _e24293 = phi_68433_;
phi_68434_ = _e24293;
}
let _e24295 = phi_68434_;
phi_68435_ = _e24295;
}
let _e24297 = phi_68435_;
local_14 = (((bitcast<i32>(_e24297) + _e24284.member_1) * _e23605) + _e24284.member);
let _e24302 = local_14;
let _e24304 = select(_e23631, _e24302, (_e24302 < _e23631));
let _e24309 = global_6.member[bitcast<u32>(select(0i, _e24304, (_e24304 > 0i)))];
let _e24314 = (((((select(_e24274, _e24278, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e24319 = ((1f - (((select(_e24278, _e24274, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e24326 = ((_e23168.member * _e24314) + (_e23176.member * _e24319));
let _e24327 = ((_e23168.member_1 * _e24314) + (_e23176.member_1 * _e24319));
let _e24328 = ((_e23168.member_2 * _e24314) + (_e23176.member_2 * _e24319));
let _e24332 = select((_e23191.member + _e24326), _e23191.member, _e23189);
let _e24333 = select((_e23191.member_1 + _e24327), _e23191.member_1, _e23189);
let _e24334 = select((_e23191.member_2 + _e24328), _e23191.member_2, _e23189);
let _e24345 = (((_e24332 * _e24332) + (_e24333 * _e24333)) + (_e24334 * _e24334));
let _e24349 = (1f / sqrt(select(0f, _e24345, (_e24345 > 0f))));
let _e24350 = (_e24332 * _e24349);
let _e24351 = (_e24333 * _e24349);
let _e24352 = (_e24334 * _e24349);
let _e24353 = (_e575 - select(_e23202.member, (_e23202.member + _e24326), _e23189));
let _e24354 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e24327), _e23189));
let _e24355 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e24328), _e23189));
let _e24360 = (((_e24353 * _e24350) + (_e24354 * _e24351)) + (_e24355 * _e24352));
let _e24365 = (((_e24353 * _e613) + (_e24354 * _e626)) + (_e24355 * _e639));
let _e24370 = (((_e24350 * _e613) + (_e24351 * _e626)) + (_e24352 * _e639));
let _e24373 = ((_e24351 * _e639) - (_e24352 * _e626));
let _e24376 = ((_e24352 * _e613) - (_e24350 * _e639));
let _e24379 = ((_e24350 * _e626) - (_e24351 * _e613));
let _e24384 = (((_e24373 * _e24373) + (_e24376 * _e24376)) + (_e24379 * _e24379));
let _e24387 = (1f / select(1e-9f, _e24384, (_e24384 > 1e-9f)));
let _e24390 = ((_e24360 - (_e24370 * _e24365)) * _e24387);
let _e24393 = (((_e24370 * _e24360) - _e24365) * _e24387);
let _e24399 = select(0f, _e24390, (((_e24393 >= 0f) && (_e24393 < _e691)) && (_e24390 > 0f)));
let _e24401 = (_e24264 << bitcast<u32>(_e24195));
let _e24413 = (_e24236 + 1i);
let _e24416 = select(_e24413, 0i, (_e24413 < 0i));
let _e24417 = (_e24416 >= _e24211.member);
if _e24417 {
phi_69096_ = (_e24211.member - 1i);
} else {
phi_69096_ = _e24416;
}
let _e24420 = phi_69096_;
if _e24267 {
phi_69107_ = (_e24211.member_1 - 1i);
} else {
phi_69107_ = _e24266;
}
let _e24423 = phi_69107_;
let _e24427 = (((f32(_e24420) + 0.5f) * _e24216) - 0.5f);
let _e24431 = (((f32(_e24423) + 0.5f) * _e24216) - 0.5f);
if _e453 {
phi_69135_ = type_23(_e24423, _e24420);
} else {
phi_69135_ = type_23(_e24420, _e24423);
}
let _e24437 = phi_69135_;
if _e24287 {
phi_69186_ = 0u;
} else {
if (_e20756 == 1u) {
phi_69185_ = 0u;
} else {
if (_e20756 == 2u) {
phi_69184_ = _e23608;
} else {
phi_69184_ = select(_e23614, _e23611, (_e20756 == 3u));
}
let _e24445 = phi_69184_;
phi_69185_ = _e24445;
}
let _e24447 = phi_69185_;
phi_69186_ = _e24447;
}
let _e24449 = phi_69186_;
local_12 = (((bitcast<i32>(_e24449) + _e24437.member_1) * _e23605) + _e24437.member);
let _e24454 = local_12;
let _e24456 = select(_e23631, _e24454, (_e24454 < _e23631));
let _e24461 = global_6.member[bitcast<u32>(select(0i, _e24456, (_e24456 > 0i)))];
let _e24466 = (((((select(_e24427, _e24431, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e24471 = ((1f - (((select(_e24431, _e24427, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e24478 = ((_e23168.member * _e24466) + (_e23176.member * _e24471));
let _e24479 = ((_e23168.member_1 * _e24466) + (_e23176.member_1 * _e24471));
let _e24480 = ((_e23168.member_2 * _e24466) + (_e23176.member_2 * _e24471));
let _e24484 = select((_e23191.member + _e24478), _e23191.member, _e23189);
let _e24485 = select((_e23191.member_1 + _e24479), _e23191.member_1, _e23189);
let _e24486 = select((_e23191.member_2 + _e24480), _e23191.member_2, _e23189);
let _e24497 = (((_e24484 * _e24484) + (_e24485 * _e24485)) + (_e24486 * _e24486));
let _e24501 = (1f / sqrt(select(0f, _e24497, (_e24497 > 0f))));
let _e24502 = (_e24484 * _e24501);
let _e24503 = (_e24485 * _e24501);
let _e24504 = (_e24486 * _e24501);
let _e24505 = (_e575 - select(_e23202.member, (_e23202.member + _e24478), _e23189));
let _e24506 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e24479), _e23189));
let _e24507 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e24480), _e23189));
let _e24512 = (((_e24505 * _e24502) + (_e24506 * _e24503)) + (_e24507 * _e24504));
let _e24517 = (((_e24505 * _e613) + (_e24506 * _e626)) + (_e24507 * _e639));
let _e24522 = (((_e24502 * _e613) + (_e24503 * _e626)) + (_e24504 * _e639));
let _e24525 = ((_e24503 * _e639) - (_e24504 * _e626));
let _e24528 = ((_e24504 * _e613) - (_e24502 * _e639));
let _e24531 = ((_e24502 * _e626) - (_e24503 * _e613));
let _e24536 = (((_e24525 * _e24525) + (_e24528 * _e24528)) + (_e24531 * _e24531));
let _e24539 = (1f / select(1e-9f, _e24536, (_e24536 > 1e-9f)));
let _e24542 = ((_e24512 - (_e24522 * _e24517)) * _e24539);
let _e24545 = (((_e24522 * _e24512) - _e24517) * _e24539);
let _e24551 = select(0f, _e24542, (((_e24545 >= 0f) && (_e24545 < _e691)) && (_e24542 > 0f)));
let _e24553 = (_e24420 << bitcast<u32>(_e24195));
let _e24565 = (_e24251 + 1i);
if _e24261 {
phi_69847_ = (_e24211.member - 1i);
} else {
phi_69847_ = _e24260;
}
let _e24569 = phi_69847_;
let _e24571 = select(_e24565, 0i, (_e24565 < 0i));
let _e24572 = (_e24571 >= _e24211.member_1);
if _e24572 {
phi_69858_ = (_e24211.member_1 - 1i);
} else {
phi_69858_ = _e24571;
}
let _e24575 = phi_69858_;
let _e24579 = (((f32(_e24569) + 0.5f) * _e24216) - 0.5f);
let _e24583 = (((f32(_e24575) + 0.5f) * _e24216) - 0.5f);
if _e453 {
phi_69886_ = type_23(_e24575, _e24569);
} else {
phi_69886_ = type_23(_e24569, _e24575);
}
let _e24589 = phi_69886_;
if _e24287 {
phi_69937_ = 0u;
} else {
if (_e20756 == 1u) {
phi_69936_ = 0u;
} else {
if (_e20756 == 2u) {
phi_69935_ = _e23608;
} else {
phi_69935_ = select(_e23614, _e23611, (_e20756 == 3u));
}
let _e24597 = phi_69935_;
phi_69936_ = _e24597;
}
let _e24599 = phi_69936_;
phi_69937_ = _e24599;
}
let _e24601 = phi_69937_;
local_10 = (((bitcast<i32>(_e24601) + _e24589.member_1) * _e23605) + _e24589.member);
let _e24606 = local_10;
let _e24608 = select(_e23631, _e24606, (_e24606 < _e23631));
let _e24613 = global_6.member[bitcast<u32>(select(0i, _e24608, (_e24608 > 0i)))];
let _e24618 = (((((select(_e24579, _e24583, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e24623 = ((1f - (((select(_e24583, _e24579, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e24630 = ((_e23168.member * _e24618) + (_e23176.member * _e24623));
let _e24631 = ((_e23168.member_1 * _e24618) + (_e23176.member_1 * _e24623));
let _e24632 = ((_e23168.member_2 * _e24618) + (_e23176.member_2 * _e24623));
let _e24636 = select((_e23191.member + _e24630), _e23191.member, _e23189);
let _e24637 = select((_e23191.member_1 + _e24631), _e23191.member_1, _e23189);
let _e24638 = select((_e23191.member_2 + _e24632), _e23191.member_2, _e23189);
let _e24649 = (((_e24636 * _e24636) + (_e24637 * _e24637)) + (_e24638 * _e24638));
let _e24653 = (1f / sqrt(select(0f, _e24649, (_e24649 > 0f))));
let _e24654 = (_e24636 * _e24653);
let _e24655 = (_e24637 * _e24653);
let _e24656 = (_e24638 * _e24653);
let _e24657 = (_e575 - select(_e23202.member, (_e23202.member + _e24630), _e23189));
let _e24658 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e24631), _e23189));
let _e24659 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e24632), _e23189));
let _e24664 = (((_e24657 * _e24654) + (_e24658 * _e24655)) + (_e24659 * _e24656));
let _e24669 = (((_e24657 * _e613) + (_e24658 * _e626)) + (_e24659 * _e639));
let _e24674 = (((_e24654 * _e613) + (_e24655 * _e626)) + (_e24656 * _e639));
let _e24677 = ((_e24655 * _e639) - (_e24656 * _e626));
let _e24680 = ((_e24656 * _e613) - (_e24654 * _e639));
let _e24683 = ((_e24654 * _e626) - (_e24655 * _e613));
let _e24688 = (((_e24677 * _e24677) + (_e24680 * _e24680)) + (_e24683 * _e24683));
let _e24691 = (1f / select(1e-9f, _e24688, (_e24688 > 1e-9f)));
let _e24694 = ((_e24664 - (_e24674 * _e24669)) * _e24691);
let _e24697 = (((_e24674 * _e24664) - _e24669) * _e24691);
let _e24703 = select(0f, _e24694, (((_e24697 >= 0f) && (_e24697 < _e691)) && (_e24694 > 0f)));
let _e24705 = (_e24569 << bitcast<u32>(_e24195));
if _e24417 {
phi_70598_ = (_e24211.member - 1i);
} else {
phi_70598_ = _e24416;
}
let _e24720 = phi_70598_;
if _e24572 {
phi_70609_ = (_e24211.member_1 - 1i);
} else {
phi_70609_ = _e24571;
}
let _e24723 = phi_70609_;
let _e24727 = (((f32(_e24720) + 0.5f) * _e24216) - 0.5f);
let _e24731 = (((f32(_e24723) + 0.5f) * _e24216) - 0.5f);
if _e453 {
phi_70637_ = type_23(_e24723, _e24720);
} else {
phi_70637_ = type_23(_e24720, _e24723);
}
let _e24737 = phi_70637_;
if _e24287 {
phi_70688_ = 0u;
} else {
if (_e20756 == 1u) {
phi_70687_ = 0u;
} else {
if (_e20756 == 2u) {
phi_70686_ = _e23608;
} else {
phi_70686_ = select(_e23614, _e23611, (_e20756 == 3u));
}
let _e24745 = phi_70686_;
phi_70687_ = _e24745;
}
let _e24747 = phi_70687_;
phi_70688_ = _e24747;
}
let _e24749 = phi_70688_;
local_8 = (((bitcast<i32>(_e24749) + _e24737.member_1) * _e23605) + _e24737.member);
let _e24754 = local_8;
let _e24756 = select(_e23631, _e24754, (_e24754 < _e23631));
let _e24761 = global_6.member[bitcast<u32>(select(0i, _e24756, (_e24756 > 0i)))];
let _e24766 = (((((select(_e24727, _e24731, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e24771 = ((1f - (((select(_e24731, _e24727, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e24778 = ((_e23168.member * _e24766) + (_e23176.member * _e24771));
let _e24779 = ((_e23168.member_1 * _e24766) + (_e23176.member_1 * _e24771));
let _e24780 = ((_e23168.member_2 * _e24766) + (_e23176.member_2 * _e24771));
let _e24784 = select((_e23191.member + _e24778), _e23191.member, _e23189);
let _e24785 = select((_e23191.member_1 + _e24779), _e23191.member_1, _e23189);
let _e24786 = select((_e23191.member_2 + _e24780), _e23191.member_2, _e23189);
let _e24797 = (((_e24784 * _e24784) + (_e24785 * _e24785)) + (_e24786 * _e24786));
let _e24801 = (1f / sqrt(select(0f, _e24797, (_e24797 > 0f))));
let _e24802 = (_e24784 * _e24801);
let _e24803 = (_e24785 * _e24801);
let _e24804 = (_e24786 * _e24801);
let _e24805 = (_e575 - select(_e23202.member, (_e23202.member + _e24778), _e23189));
let _e24806 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e24779), _e23189));
let _e24807 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e24780), _e23189));
let _e24812 = (((_e24805 * _e24802) + (_e24806 * _e24803)) + (_e24807 * _e24804));
let _e24817 = (((_e24805 * _e613) + (_e24806 * _e626)) + (_e24807 * _e639));
let _e24822 = (((_e24802 * _e613) + (_e24803 * _e626)) + (_e24804 * _e639));
let _e24825 = ((_e24803 * _e639) - (_e24804 * _e626));
let _e24828 = ((_e24804 * _e613) - (_e24802 * _e639));
let _e24831 = ((_e24802 * _e626) - (_e24803 * _e613));
let _e24836 = (((_e24825 * _e24825) + (_e24828 * _e24828)) + (_e24831 * _e24831));
let _e24839 = (1f / select(1e-9f, _e24836, (_e24836 > 1e-9f)));
let _e24842 = ((_e24812 - (_e24822 * _e24817)) * _e24839);
let _e24845 = (((_e24822 * _e24812) - _e24817) * _e24839);
let _e24851 = select(0f, _e24842, (((_e24845 >= 0f) && (_e24845 < _e691)) && (_e24842 > 0f)));
let _e24853 = (_e24720 << bitcast<u32>(_e24195));
let _e24865 = select(((((_e24194 - select(0f, (_e24256 * _e24257), (((select(select(_e766, _e927, (_e24401 >= _e692)), _e847, (_e24401 < _e298)) == _e20756) && (_e24399 > 0f)) && (_e24399 < _e24309)))) - select(0f, (_e24253 * _e24257), (((select(select(_e766, _e927, (_e24553 >= _e692)), _e847, (_e24553 < _e298)) == _e20756) && (_e24551 > 0f)) && (_e24551 < _e24461)))) - select(0f, (_e24256 * _e24255), (((select(select(_e766, _e927, (_e24705 >= _e692)), _e847, (_e24705 < _e298)) == _e20756) && (_e24703 > 0f)) && (_e24703 < _e24613)))) - select(0f, (_e24253 * _e24255), (((select(select(_e766, _e927, (_e24853 >= _e692)), _e847, (_e24853 < _e298)) == _e20756) && (_e24851 > 0f)) && (_e24851 < _e24761)))), _e24194, _e24287);
let _e24866 = (_e20760 & 31u);
let _e24868 = (1u << bitcast<u32>(_e24866));
let _e24877 = bitcast<i32>((((_e14761 + _e24868) - 1u) >> bitcast<u32>(_e24866)));
let _e24878 = bitcast<i32>((((_e14764 + _e24868) - 1u) >> bitcast<u32>(_e24866)));
if _e453 {
phi_71367_ = type_23(_e24878, _e24877);
} else {
phi_71367_ = type_23(_e24877, _e24878);
}
let _e24882 = phi_71367_;
let _e24887 = f32((1i << bitcast<u32>(_e24866)));
let _e24888 = (1f / _e24887);
let _e24890 = ((_e22975 * _e24888) - 0.5f);
let _e24892 = ((_e23069 * _e24888) - 0.5f);
let _e24894 = select(-1f, _e24890, (_e24890 > -1f));
let _e24896 = select(1e6f, _e24894, (_e24894 < 1e6f));
let _e24903 = select(0i, select(select(i32(_e24896), i32(-2147483648), (_e24896 < -2147483600f)), 2147483647i, (_e24896 > 2147483500f)), (_e24896 == _e24896));
let _e24907 = (_e24903 - select(0i, 1i, (_e24896 < f32(_e24903))));
let _e24909 = select(-1f, _e24892, (_e24892 > -1f));
let _e24911 = select(1e6f, _e24909, (_e24909 < 1e6f));
let _e24918 = select(0i, select(select(i32(_e24911), i32(-2147483648), (_e24911 < -2147483600f)), 2147483647i, (_e24911 > 2147483500f)), (_e24911 == _e24911));
let _e24922 = (_e24918 - select(0i, 1i, (_e24911 < f32(_e24918))));
let _e24924 = (_e24890 - f32(_e24907));
let _e24926 = (_e24892 - f32(_e24922));
let _e24927 = (1f - _e24924);
let _e24928 = (1f - _e24926);
let _e24931 = select(_e24907, 0i, (_e24907 < 0i));
let _e24932 = (_e24931 >= _e24882.member);
if _e24932 {
phi_71445_ = (_e24882.member - 1i);
} else {
phi_71445_ = _e24931;
}
let _e24935 = phi_71445_;
let _e24937 = select(_e24922, 0i, (_e24922 < 0i));
let _e24938 = (_e24937 >= _e24882.member_1);
if _e24938 {
phi_71456_ = (_e24882.member_1 - 1i);
} else {
phi_71456_ = _e24937;
}
let _e24941 = phi_71456_;
let _e24945 = (((f32(_e24935) + 0.5f) * _e24887) - 0.5f);
let _e24949 = (((f32(_e24941) + 0.5f) * _e24887) - 0.5f);
if _e453 {
phi_71484_ = type_23(_e24941, _e24935);
} else {
phi_71484_ = type_23(_e24935, _e24941);
}
let _e24955 = phi_71484_;
let _e24958 = (_e20760 == 0u);
if _e24958 {
phi_71535_ = 0u;
} else {
if (_e20760 == 1u) {
phi_71534_ = 0u;
} else {
if (_e20760 == 2u) {
phi_71533_ = _e23608;
} else {
phi_71533_ = select(_e23614, _e23611, (_e20760 == 3u));
}
let _e24964 = phi_71533_;
phi_71534_ = _e24964;
}
let _e24966 = phi_71534_;
phi_71535_ = _e24966;
}
let _e24968 = phi_71535_;
local_6 = (((bitcast<i32>(_e24968) + _e24955.member_1) * _e23605) + _e24955.member);
let _e24973 = local_6;
let _e24975 = select(_e23631, _e24973, (_e24973 < _e23631));
let _e24980 = global_6.member[bitcast<u32>(select(0i, _e24975, (_e24975 > 0i)))];
let _e24985 = (((((select(_e24945, _e24949, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e24990 = ((1f - (((select(_e24949, _e24945, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e24997 = ((_e23168.member * _e24985) + (_e23176.member * _e24990));
let _e24998 = ((_e23168.member_1 * _e24985) + (_e23176.member_1 * _e24990));
let _e24999 = ((_e23168.member_2 * _e24985) + (_e23176.member_2 * _e24990));
let _e25003 = select((_e23191.member + _e24997), _e23191.member, _e23189);
let _e25004 = select((_e23191.member_1 + _e24998), _e23191.member_1, _e23189);
let _e25005 = select((_e23191.member_2 + _e24999), _e23191.member_2, _e23189);
let _e25016 = (((_e25003 * _e25003) + (_e25004 * _e25004)) + (_e25005 * _e25005));
let _e25020 = (1f / sqrt(select(0f, _e25016, (_e25016 > 0f))));
let _e25021 = (_e25003 * _e25020);
let _e25022 = (_e25004 * _e25020);
let _e25023 = (_e25005 * _e25020);
let _e25024 = (_e575 - select(_e23202.member, (_e23202.member + _e24997), _e23189));
let _e25025 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e24998), _e23189));
let _e25026 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e24999), _e23189));
let _e25031 = (((_e25024 * _e25021) + (_e25025 * _e25022)) + (_e25026 * _e25023));
let _e25036 = (((_e25024 * _e613) + (_e25025 * _e626)) + (_e25026 * _e639));
let _e25041 = (((_e25021 * _e613) + (_e25022 * _e626)) + (_e25023 * _e639));
let _e25044 = ((_e25022 * _e639) - (_e25023 * _e626));
let _e25047 = ((_e25023 * _e613) - (_e25021 * _e639));
let _e25050 = ((_e25021 * _e626) - (_e25022 * _e613));
let _e25055 = (((_e25044 * _e25044) + (_e25047 * _e25047)) + (_e25050 * _e25050));
let _e25058 = (1f / select(1e-9f, _e25055, (_e25055 > 1e-9f)));
let _e25061 = ((_e25031 - (_e25041 * _e25036)) * _e25058);
let _e25064 = (((_e25041 * _e25031) - _e25036) * _e25058);
let _e25070 = select(0f, _e25061, (((_e25064 >= 0f) && (_e25064 < _e691)) && (_e25061 > 0f)));
let _e25072 = (_e24935 << bitcast<u32>(_e24866));
let _e25084 = (_e24907 + 1i);
let _e25087 = select(_e25084, 0i, (_e25084 < 0i));
let _e25088 = (_e25087 >= _e24882.member);
if _e25088 {
phi_72196_ = (_e24882.member - 1i);
} else {
phi_72196_ = _e25087;
}
let _e25091 = phi_72196_;
if _e24938 {
phi_72207_ = (_e24882.member_1 - 1i);
} else {
phi_72207_ = _e24937;
}
let _e25094 = phi_72207_;
let _e25098 = (((f32(_e25091) + 0.5f) * _e24887) - 0.5f);
let _e25102 = (((f32(_e25094) + 0.5f) * _e24887) - 0.5f);
if _e453 {
phi_72235_ = type_23(_e25094, _e25091);
} else {
phi_72235_ = type_23(_e25091, _e25094);
}
let _e25108 = phi_72235_;
if _e24958 {
phi_72286_ = 0u;
} else {
if (_e20760 == 1u) {
phi_72285_ = 0u;
} else {
if (_e20760 == 2u) {
phi_72284_ = _e23608;
} else {
phi_72284_ = select(_e23614, _e23611, (_e20760 == 3u));
}
let _e25116 = phi_72284_;
phi_72285_ = _e25116;
}
let _e25118 = phi_72285_;
phi_72286_ = _e25118;
}
let _e25120 = phi_72286_;
local_4 = (((bitcast<i32>(_e25120) + _e25108.member_1) * _e23605) + _e25108.member);
let _e25125 = local_4;
let _e25127 = select(_e23631, _e25125, (_e25125 < _e23631));
let _e25132 = global_6.member[bitcast<u32>(select(0i, _e25127, (_e25127 > 0i)))];
let _e25137 = (((((select(_e25098, _e25102, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e25142 = ((1f - (((select(_e25102, _e25098, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e25149 = ((_e23168.member * _e25137) + (_e23176.member * _e25142));
let _e25150 = ((_e23168.member_1 * _e25137) + (_e23176.member_1 * _e25142));
let _e25151 = ((_e23168.member_2 * _e25137) + (_e23176.member_2 * _e25142));
let _e25155 = select((_e23191.member + _e25149), _e23191.member, _e23189);
let _e25156 = select((_e23191.member_1 + _e25150), _e23191.member_1, _e23189);
let _e25157 = select((_e23191.member_2 + _e25151), _e23191.member_2, _e23189);
let _e25168 = (((_e25155 * _e25155) + (_e25156 * _e25156)) + (_e25157 * _e25157));
let _e25172 = (1f / sqrt(select(0f, _e25168, (_e25168 > 0f))));
let _e25173 = (_e25155 * _e25172);
let _e25174 = (_e25156 * _e25172);
let _e25175 = (_e25157 * _e25172);
let _e25176 = (_e575 - select(_e23202.member, (_e23202.member + _e25149), _e23189));
let _e25177 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e25150), _e23189));
let _e25178 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e25151), _e23189));
let _e25183 = (((_e25176 * _e25173) + (_e25177 * _e25174)) + (_e25178 * _e25175));
let _e25188 = (((_e25176 * _e613) + (_e25177 * _e626)) + (_e25178 * _e639));
let _e25193 = (((_e25173 * _e613) + (_e25174 * _e626)) + (_e25175 * _e639));
let _e25196 = ((_e25174 * _e639) - (_e25175 * _e626));
let _e25199 = ((_e25175 * _e613) - (_e25173 * _e639));
let _e25202 = ((_e25173 * _e626) - (_e25174 * _e613));
let _e25207 = (((_e25196 * _e25196) + (_e25199 * _e25199)) + (_e25202 * _e25202));
let _e25210 = (1f / select(1e-9f, _e25207, (_e25207 > 1e-9f)));
let _e25213 = ((_e25183 - (_e25193 * _e25188)) * _e25210);
let _e25216 = (((_e25193 * _e25183) - _e25188) * _e25210);
let _e25222 = select(0f, _e25213, (((_e25216 >= 0f) && (_e25216 < _e691)) && (_e25213 > 0f)));
let _e25224 = (_e25091 << bitcast<u32>(_e24866));
let _e25236 = (_e24922 + 1i);
if _e24932 {
phi_72947_ = (_e24882.member - 1i);
} else {
phi_72947_ = _e24931;
}
let _e25240 = phi_72947_;
let _e25242 = select(_e25236, 0i, (_e25236 < 0i));
let _e25243 = (_e25242 >= _e24882.member_1);
if _e25243 {
phi_72958_ = (_e24882.member_1 - 1i);
} else {
phi_72958_ = _e25242;
}
let _e25246 = phi_72958_;
let _e25250 = (((f32(_e25240) + 0.5f) * _e24887) - 0.5f);
let _e25254 = (((f32(_e25246) + 0.5f) * _e24887) - 0.5f);
if _e453 {
phi_72986_ = type_23(_e25246, _e25240);
} else {
phi_72986_ = type_23(_e25240, _e25246);
}
let _e25260 = phi_72986_;
if _e24958 {
phi_73037_ = 0u;
} else {
if (_e20760 == 1u) {
phi_73036_ = 0u;
} else {
if (_e20760 == 2u) {
phi_73035_ = _e23608;
} else {
phi_73035_ = select(_e23614, _e23611, (_e20760 == 3u));
}
let _e25268 = phi_73035_;
phi_73036_ = _e25268;
}
let _e25270 = phi_73036_;
phi_73037_ = _e25270;
}
let _e25272 = phi_73037_;
local_2 = (((bitcast<i32>(_e25272) + _e25260.member_1) * _e23605) + _e25260.member);
let _e25277 = local_2;
let _e25279 = select(_e23631, _e25277, (_e25277 < _e23631));
let _e25284 = global_6.member[bitcast<u32>(select(0i, _e25279, (_e25279 > 0i)))];
let _e25289 = (((((select(_e25250, _e25254, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e25294 = ((1f - (((select(_e25254, _e25250, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e25301 = ((_e23168.member * _e25289) + (_e23176.member * _e25294));
let _e25302 = ((_e23168.member_1 * _e25289) + (_e23176.member_1 * _e25294));
let _e25303 = ((_e23168.member_2 * _e25289) + (_e23176.member_2 * _e25294));
let _e25307 = select((_e23191.member + _e25301), _e23191.member, _e23189);
let _e25308 = select((_e23191.member_1 + _e25302), _e23191.member_1, _e23189);
let _e25309 = select((_e23191.member_2 + _e25303), _e23191.member_2, _e23189);
let _e25320 = (((_e25307 * _e25307) + (_e25308 * _e25308)) + (_e25309 * _e25309));
let _e25324 = (1f / sqrt(select(0f, _e25320, (_e25320 > 0f))));
let _e25325 = (_e25307 * _e25324);
let _e25326 = (_e25308 * _e25324);
let _e25327 = (_e25309 * _e25324);
let _e25328 = (_e575 - select(_e23202.member, (_e23202.member + _e25301), _e23189));
let _e25329 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e25302), _e23189));
let _e25330 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e25303), _e23189));
let _e25335 = (((_e25328 * _e25325) + (_e25329 * _e25326)) + (_e25330 * _e25327));
let _e25340 = (((_e25328 * _e613) + (_e25329 * _e626)) + (_e25330 * _e639));
let _e25345 = (((_e25325 * _e613) + (_e25326 * _e626)) + (_e25327 * _e639));
let _e25348 = ((_e25326 * _e639) - (_e25327 * _e626));
let _e25351 = ((_e25327 * _e613) - (_e25325 * _e639));
let _e25354 = ((_e25325 * _e626) - (_e25326 * _e613));
let _e25359 = (((_e25348 * _e25348) + (_e25351 * _e25351)) + (_e25354 * _e25354));
let _e25362 = (1f / select(1e-9f, _e25359, (_e25359 > 1e-9f)));
let _e25365 = ((_e25335 - (_e25345 * _e25340)) * _e25362);
let _e25368 = (((_e25345 * _e25335) - _e25340) * _e25362);
let _e25374 = select(0f, _e25365, (((_e25368 >= 0f) && (_e25368 < _e691)) && (_e25365 > 0f)));
let _e25376 = (_e25240 << bitcast<u32>(_e24866));
if _e25088 {
phi_73698_ = (_e24882.member - 1i);
} else {
phi_73698_ = _e25087;
}
let _e25391 = phi_73698_;
if _e25243 {
phi_73709_ = (_e24882.member_1 - 1i);
} else {
phi_73709_ = _e25242;
}
let _e25394 = phi_73709_;
let _e25398 = (((f32(_e25391) + 0.5f) * _e24887) - 0.5f);
let _e25402 = (((f32(_e25394) + 0.5f) * _e24887) - 0.5f);
if _e453 {
phi_73737_ = type_23(_e25394, _e25391);
} else {
phi_73737_ = type_23(_e25391, _e25394);
}
let _e25408 = phi_73737_;
if _e24958 {
phi_73788_ = 0u;
} else {
if (_e20760 == 1u) {
phi_73787_ = 0u;
} else {
if (_e20760 == 2u) {
phi_73786_ = _e23608;
} else {
phi_73786_ = select(_e23614, _e23611, (_e20760 == 3u));
}
let _e25416 = phi_73786_;
phi_73787_ = _e25416;
}
let _e25418 = phi_73787_;
phi_73788_ = _e25418;
}
let _e25420 = phi_73788_;
local = (((bitcast<i32>(_e25420) + _e25408.member_1) * _e23605) + _e25408.member);
let _e25425 = local;
let _e25427 = select(_e23631, _e25425, (_e25425 < _e23631));
let _e25432 = global_6.member[bitcast<u32>(select(0i, _e25427, (_e25427 > 0i)))];
let _e25437 = (((((select(_e25398, _e25402, _e453) + 0.5f) / _e23149) * 2f) - 1f) * _e23157);
let _e25442 = ((1f - (((select(_e25402, _e25398, _e453) + 0.5f) / _e23150) * 2f)) * _e23165);
let _e25449 = ((_e23168.member * _e25437) + (_e23176.member * _e25442));
let _e25450 = ((_e23168.member_1 * _e25437) + (_e23176.member_1 * _e25442));
let _e25451 = ((_e23168.member_2 * _e25437) + (_e23176.member_2 * _e25442));
let _e25455 = select((_e23191.member + _e25449), _e23191.member, _e23189);
let _e25456 = select((_e23191.member_1 + _e25450), _e23191.member_1, _e23189);
let _e25457 = select((_e23191.member_2 + _e25451), _e23191.member_2, _e23189);
let _e25468 = (((_e25455 * _e25455) + (_e25456 * _e25456)) + (_e25457 * _e25457));
let _e25472 = (1f / sqrt(select(0f, _e25468, (_e25468 > 0f))));
let _e25473 = (_e25455 * _e25472);
let _e25474 = (_e25456 * _e25472);
let _e25475 = (_e25457 * _e25472);
let _e25476 = (_e575 - select(_e23202.member, (_e23202.member + _e25449), _e23189));
let _e25477 = (_e587 - select(_e23202.member_1, (_e23202.member_1 + _e25450), _e23189));
let _e25478 = (_e600 - select(_e23202.member_2, (_e23202.member_2 + _e25451), _e23189));
let _e25483 = (((_e25476 * _e25473) + (_e25477 * _e25474)) + (_e25478 * _e25475));
let _e25488 = (((_e25476 * _e613) + (_e25477 * _e626)) + (_e25478 * _e639));
let _e25493 = (((_e25473 * _e613) + (_e25474 * _e626)) + (_e25475 * _e639));
let _e25496 = ((_e25474 * _e639) - (_e25475 * _e626));
let _e25499 = ((_e25475 * _e613) - (_e25473 * _e639));
let _e25502 = ((_e25473 * _e626) - (_e25474 * _e613));
let _e25507 = (((_e25496 * _e25496) + (_e25499 * _e25499)) + (_e25502 * _e25502));
let _e25510 = (1f / select(1e-9f, _e25507, (_e25507 > 1e-9f)));
let _e25513 = ((_e25483 - (_e25493 * _e25488)) * _e25510);
let _e25516 = (((_e25493 * _e25483) - _e25488) * _e25510);
let _e25522 = select(0f, _e25513, (((_e25516 >= 0f) && (_e25516 < _e691)) && (_e25513 > 0f)));
let _e25524 = (_e25391 << bitcast<u32>(_e24866));
let _e25536 = select(((((_e24865 - select(0f, (_e24927 * _e24928), (((select(select(_e766, _e927, (_e25072 >= _e692)), _e847, (_e25072 < _e298)) == _e20760) && (_e25070 > 0f)) && (_e25070 < _e24980)))) - select(0f, (_e24924 * _e24928), (((select(select(_e766, _e927, (_e25224 >= _e692)), _e847, (_e25224 < _e298)) == _e20760) && (_e25222 > 0f)) && (_e25222 < _e25132)))) - select(0f, (_e24927 * _e24926), (((select(select(_e766, _e927, (_e25376 >= _e692)), _e847, (_e25376 < _e298)) == _e20760) && (_e25374 > 0f)) && (_e25374 < _e25284)))) - select(0f, (_e24924 * _e24926), (((select(select(_e766, _e927, (_e25524 >= _e692)), _e847, (_e25524 < _e298)) == _e20760) && (_e25522 > 0f)) && (_e25522 < _e25432)))), _e24865, _e24958);
if _e453 {
phi_74458_ = type_23(_e23066, _e22973);
} else {
phi_74458_ = type_23(_e22973, _e23066);
}
let _e25551 = phi_74458_;
let _e25554 = (_e23067 && (((_e23522 > 0f) && (_e23522 < _e23146)) && (bitcast<f32>((bitcast<u32>(_e25536) & 2147483647u)) > 1e-6f)));
let _e25557 = global_1.member.member_18.member;
let _e25558 = (((select(_e23092, (1f - _e23092), (_e23077 >= 0f)) - select(_e23111, (1f - _e23111), (_e23096 >= 0f))) * (1f / _e23074)) * _e25557);
let _e25562 = select(0f, (((((_e652 * _e23359.member) * ((1f + (_e23399 * (1f + (_e23399 * (0.5f + (_e23399 * (0.16666667f + (_e23399 * (0.041666668f + (_e23399 * (0.008333334f + (_e23399 * (0.001388889f + (_e23399 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23394 + 127i)) << bitcast<u32>(23i))))) * _e23352) * _e25536) * _e25558), _e25554);
let _e25563 = select(0f, (((((_e665 * _e23359.member_1) * ((1f + (_e23447 * (1f + (_e23447 * (0.5f + (_e23447 * (0.16666667f + (_e23447 * (0.041666668f + (_e23447 * (0.008333334f + (_e23447 * (0.001388889f + (_e23447 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23442 + 127i)) << bitcast<u32>(23i))))) * _e23352) * _e25536) * _e25558), _e25554);
let _e25564 = select(0f, (((((_e678 * _e23359.member_2) * ((1f + (_e23495 * (1f + (_e23495 * (0.5f + (_e23495 * (0.16666667f + (_e23495 * (0.041666668f + (_e23495 * (0.008333334f + (_e23495 * (0.001388889f + (_e23495 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23490 + 127i)) << bitcast<u32>(23i))))) * _e23352) * _e25536) * _e25558), _e25554);
let _e25568 = (bitcast<f32>((bitcast<u32>(_e25562) & 2147483647u)) >= 1073741800f);
let _e25569 = (1f / 1048576f);
let _e25572 = ((_e25562 * select(1f, _e25569, _e25568)) + 0.5f);
let _e25574 = select(-1073741800f, _e25572, (_e25572 > -1073741800f));
let _e25576 = select(1073741800f, _e25574, (_e25574 < 1073741800f));
let _e25583 = select(0i, select(select(i32(_e25576), i32(-2147483648), (_e25576 < -2147483600f)), 2147483647i, (_e25576 > 2147483500f)), (_e25576 == _e25576));
let _e25587 = (_e25583 - select(0i, 1i, (_e25576 < f32(_e25583))));
let _e25588 = select(0i, 20i, _e25568);
let _e25592 = (bitcast<u32>(_e25587) << bitcast<u32>((_e25588 & 31i)));
let _e25599 = bitcast<u32>(((_e25587 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25588) & 31i))));
let _e25603 = (bitcast<f32>((bitcast<u32>(_e25563) & 2147483647u)) >= 1073741800f);
let _e25606 = ((_e25563 * select(1f, _e25569, _e25603)) + 0.5f);
let _e25608 = select(-1073741800f, _e25606, (_e25606 > -1073741800f));
let _e25610 = select(1073741800f, _e25608, (_e25608 < 1073741800f));
let _e25617 = select(0i, select(select(i32(_e25610), i32(-2147483648), (_e25610 < -2147483600f)), 2147483647i, (_e25610 > 2147483500f)), (_e25610 == _e25610));
let _e25621 = (_e25617 - select(0i, 1i, (_e25610 < f32(_e25617))));
let _e25622 = select(0i, 20i, _e25603);
let _e25626 = (bitcast<u32>(_e25621) << bitcast<u32>((_e25622 & 31i)));
let _e25633 = bitcast<u32>(((_e25621 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25622) & 31i))));
let _e25637 = (bitcast<f32>((bitcast<u32>(_e25564) & 2147483647u)) >= 1073741800f);
let _e25640 = ((_e25564 * select(1f, _e25569, _e25637)) + 0.5f);
let _e25642 = select(-1073741800f, _e25640, (_e25640 > -1073741800f));
let _e25644 = select(1073741800f, _e25642, (_e25642 < 1073741800f));
let _e25651 = select(0i, select(select(i32(_e25644), i32(-2147483648), (_e25644 < -2147483600f)), 2147483647i, (_e25644 > 2147483500f)), (_e25644 == _e25644));
let _e25655 = (_e25651 - select(0i, 1i, (_e25644 < f32(_e25651))));
let _e25656 = select(0i, 20i, _e25637);
let _e25660 = (bitcast<u32>(_e25655) << bitcast<u32>((_e25656 & 31i)));
let _e25667 = bitcast<u32>(((_e25655 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25656) & 31i))));
let _e25672 = bitcast<i32>(bitcast<u32>((((_e25551.member_1 * _e14765) + _e25551.member) * 6i)));
if ((_e25592 | _e25599) == 0u) {
} else {
let _e25675 = bitcast<u32>(_e25672);
if (_e25675 < _e270) {
let _e25679 = atomicAdd((&global_8.member[_e25675]), _e25592);
phi_74691_ = _e25679;
} else {
phi_74691_ = 0u;
}
let _e25681 = phi_74691_;
let _e25685 = (_e25599 + select(0u, 1u, ((_e25681 + _e25592) < _e25592)));
if (_e25685 == 0u) {
} else {
let _e25687 = (_e25675 + 1u);
if (_e25687 < _e270) {
let _e25691 = atomicAdd((&global_8.member[_e25687]), _e25685);
}
}
}
if ((_e25626 | _e25633) == 0u) {
} else {
let _e25695 = bitcast<u32>((_e25672 + 2i));
if (_e25695 < _e270) {
let _e25699 = atomicAdd((&global_8.member[_e25695]), _e25626);
phi_74721_ = _e25699;
} else {
phi_74721_ = 0u;
}
let _e25701 = phi_74721_;
let _e25705 = (_e25633 + select(0u, 1u, ((_e25701 + _e25626) < _e25626)));
if (_e25705 == 0u) {
} else {
let _e25707 = (_e25695 + 1u);
if (_e25707 < _e270) {
let _e25711 = atomicAdd((&global_8.member[_e25707]), _e25705);
}
}
}
if ((_e25660 | _e25667) == 0u) {
} else {
let _e25715 = bitcast<u32>((_e25672 + 4i));
if (_e25715 < _e270) {
let _e25719 = atomicAdd((&global_8.member[_e25715]), _e25660);
phi_74751_ = _e25719;
} else {
phi_74751_ = 0u;
}
let _e25721 = phi_74751_;
let _e25725 = (_e25667 + select(0u, 1u, ((_e25721 + _e25660) < _e25660)));
if (_e25725 == 0u) {
} else {
let _e25727 = (_e25715 + 1u);
if (_e25727 < _e270) {
let _e25731 = atomicAdd((&global_8.member[_e25727]), _e25725);
}
}
}
phi_64367_ = (_e23064 + 1i);
} else {
phi_64367_ = i32();
}
let _e25734 = phi_64367_;
continue;
continuing {
phi_64366_ = _e25734;
break if !(_e23067);
}
}
phi_64213_ = (_e22970 + 1i);
} else {
phi_64213_ = i32();
}
let _e25738 = phi_64213_;
continue;
continuing {
phi_64212_ = _e25738;
break if !(_e22971);
}
}
}
}
}
}
}
}
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
